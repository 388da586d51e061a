"""Pictures of bodies in space by VTK, which draws into a display of its own (display.py)."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

from plotting.figure import ORANGE
from plotting.space import files
from plotting.space.display import start_display
from plotting.space.grids import clipped, cut, poly

LITTLE, OPAQUE, TRANSPARENT = 0.25, 0.4, 0.15   # size of a tool over the workpiece's, below which it is opaque; how far tools are
STEEL, RIM, BODY, EDGE = (0.55, 0.60, 0.68), (0.30, 0.35, 0.42), (0.93, 0.91, 0.86), (0.35, 0.35, 0.35)

DENSE = 3000  # triangles of a tool whose lines are no longer told apart
APART = 2e-3  # how far lines lie before faces and tools behind them, over the size of the workpiece


def smoothed(data):
    """With normals for the light, which keep edges that are sharper than 35 degrees."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SetFeatureAngle(35)
    normals.Update()
    return normals.GetOutput()


def lookup(colors):
    """colors: n x 4, 0..1"""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(colors))
    for k, color in enumerate(colors):
        table.SetTableValue(k, *color)
    return table


class Scene:
    """Bodies that are added, seen by `look`, drawn once by `image`; points: all of theirs."""

    def __init__(self, size=(1300, 1000)):
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        self.renderer.SetBackground(1, 1, 1)
        self.window.SetAlphaBitPlanes(True)
        self.window.SetMultiSamples(0)
        self.renderer.SetUseFXAA(True)
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(*size)
        self.size, self.points = size, []
        self.window.AddRenderer(self.renderer)

    def add(self, data, color=None, opacity=1.0, width=None, bands=None):
        """width: of lines, which have no light and shade; bands: (table of colors, limits of the scalars)"""
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputData(data)
        mapper.SetScalarVisibility(bands is not None)
        if bands is not None:
            mapper.SetLookupTable(bands[0])
            mapper.SetScalarRange(*bands[1])
            mapper.SetInterpolateScalarsBeforeMapping(True)
        actor.SetMapper(mapper)
        look = actor.GetProperty()
        if data.GetNumberOfPoints():
            self.points.append(vtk_to_numpy(data.GetPoints().GetData()))
        if color:
            look.SetColor(*color)
        look.SetOpacity(opacity)
        look.SetAmbient(0.35 if bands is None else 0.75)  # of a field so much that its colors are those of the scale
        look.SetDiffuse(0.7 if bands is None else 0.3)
        if width:
            look.SetLineWidth(width)
            look.SetLighting(False)
        self.renderer.AddActor(actor)

    def add_body(self, body, eye, values=None, colors=None, limits=None):
        """Outer faces with the edges of the elements, these a little toward the eye; values at the nodes by colors (n x 4) between the limits."""
        data = poly(body.points, files.triangles_of(body.faces))
        if values is not None:
            data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values, float), deep=True))
        self.add(smoothed(data), BODY, bands=None if values is None else (lookup(colors), limits))
        shift = APART * np.ptp(body.points, axis=0).max() * eye
        self.add(poly(body.points + shift, body.lines, "lines"), EDGE, 0.4, 1.0)

    def add_tools(self, tools, shift, side, behind=None):
        """With the lines of their triangles, which show how they turn, where these are few; moved by a shift that nobody sees, so that the contact is
        that of the workpiece. A tool that is small beside the workpiece, of this side, hides little of it and is less transparent.
        behind: normal of a plane through 0 that cuts them."""
        for _, points, triangles, _ in files.tool_parts(tools):
            opacity = OPAQUE if np.ptp(points, axis=0).max() < LITTLE * side else TRANSPARENT
            points = points + shift
            self.add(clipped(smoothed(poly(points, triangles)), behind), STEEL, opacity)
            if behind is not None:
                self.add(cut(poly(points, triangles), np.zeros(3), behind), RIM, 1.0, 1.5)
            if len(triangles) < DENSE:
                self.add(clipped(poly(points, files.edges_of(triangles), "lines"), behind), STEEL, 0.5 * opacity, 1.0)

    def add_track(self, places, radius, color=ORANGE):
        """A tube through the places with a ball at its end."""
        rgb = tuple(int(color[k:k + 2], 16) / 255 for k in (1, 3, 5))
        tube = vtkTubeFilter()
        tube.SetInputData(poly(places, np.arange(len(places))[None], "lines"))
        tube.SetRadius(radius)
        tube.SetNumberOfSides(12)
        tube.CappingOn()
        tube.Update()
        self.add(tube.GetOutput(), rgb)

    def look(self, eye, up, box):
        """box: low and high corner of what is to be seen."""
        self.eye = eye
        camera, middle = self.renderer.GetActiveCamera(), 0.5 * (box[0] + box[1])
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(middle + eye))
        camera.SetViewUp(*up)
        camera.SetViewAngle(18)
        self.renderer.ResetCamera(*np.column_stack(box).ravel())
        self.renderer.ResetCameraClippingRange()
        for direction, strength in ((eye, 0.55), (up + 0.4 * eye, 0.6)):
            light = vtkLight()
            light.SetPosition(*(middle + direction))
            light.SetFocalPoint(*middle)
            light.SetIntensity(strength)
            self.renderer.AddLight(light)

    def narrow(self, columns, rows, size):
        """Draws only these pixels (first, last), rows upward, by `size` pixels: what is cut off costs nothing, what stays is as sharp as it can be."""
        camera, (width, height) = self.renderer.GetActiveCamera(), self.size
        (left, right), (low, high) = columns, rows
        camera.SetViewAngle(2 * np.degrees(np.arctan(np.tan(np.radians(camera.GetViewAngle() / 2)) * (high - low) / height)))
        camera.SetWindowCenter((left + right - width) / (right - left), (low + high - height) / (high - low))
        actors = self.renderer.GetActors()
        actors.InitTraversal()
        while actor := actors.GetNextActor():
            actor.GetProperty().SetLineWidth(actor.GetProperty().GetLineWidth() * size[0] / (right - left))
        self.size = size
        self.window.SetSize(*size)

    def image(self):
        """Numbers h x w x 3."""
        start_display().wait()
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()  # it would draw all again
        grab.Update()
        picture = grab.GetOutput()
        width, height, _ = picture.GetDimensions()
        pixels = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].copy()
        self.window.Finalize()  # before the display goes
        return pixels

    def pixels(self, points):
        """Places of points in the image, x to the right and y upward from its lower edge."""
        width, height = self.size
        matrix = self.renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(width / height, -1, 1)
        m = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        clip = np.column_stack([points, np.ones(len(points))]) @ m.T
        return (0.5 + 0.5 * clip[:, :2] / clip[:, 3:]) * (width, height)
