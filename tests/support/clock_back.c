/* A system clock that somebody sets back by a day: preloaded, from when the file $CLOCK_BACK is there. The steady clock goes on. */
#define _GNU_SOURCE
#include <stdlib.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static int set_back(void) {
  const char* file = getenv("CLOCK_BACK");
  return file && access(file, F_OK) == 0;
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  const int code = (int)syscall(SYS_clock_gettime, clock, now);
  if (code == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) && set_back()) now->tv_sec -= 86400;
  return code;
}

int gettimeofday(struct timeval* now, void* zone) {
  struct timespec fine;
  (void)zone;
  clock_gettime(CLOCK_REALTIME, &fine);
  now->tv_sec = fine.tv_sec;
  now->tv_usec = fine.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* kept) {
  struct timespec fine;
  clock_gettime(CLOCK_REALTIME, &fine);
  if (kept) *kept = fine.tv_sec;
  return fine.tv_sec;
}
