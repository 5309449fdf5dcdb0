package org.dfra.river.registrar;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.jini.thread.TaskManager;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Requests by multicast that never end hold up no other task of a lookup service. */
@Timeout(30)
class RegistrarTaskManagerTest {

  /** More than reggie has threads. */
  private static final int MANY = 200;

  private final RegistrarTaskManager tasks = new RegistrarTaskManager();
  private final AtomicInteger begun = new AtomicInteger();
  private final CountDownLatch allThreads = new CountDownLatch(RegistrarTaskManager.THREADS);
  private final CountDownLatch release = new CountDownLatch(1);

  @AfterEach
  void end() {
    release.countDown();
    tasks.terminate();
  }

  /** Has the name of reggie's answer to a request, and never ends by itself. */
  private final class AddressTask implements TaskManager.Task {

    @Override
    public void run() {
      begun.incrementAndGet();
      allThreads.countDown();
      try {
        release.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt(); // the tasks are terminated
      }
    }

    @Override
    @SuppressWarnings("rawtypes") // as River declares it
    public boolean runAfter(List tasks, int size) {
      return false;
    }
  }

  /** Has the name of reggie's report of an event. */
  private record EventTask(CountDownLatch reported) implements TaskManager.Task {

    @Override
    public void run() {
      reported.countDown();
    }

    @Override
    @SuppressWarnings("rawtypes") // as River declares it
    public boolean runAfter(List tasks, int size) {
      return false;
    }
  }

  @Test
  void requestsThatHangHoldUpNoEvent() throws Exception {
    for (int i = 0; i < MANY; i++) {
      tasks.add(new AddressTask());
      tasks.addIfNew(new AddressTask());
    }
    assertThat(allThreads.await(10, TimeUnit.SECONDS)).isTrue();
    CountDownLatch reported = new CountDownLatch(1);
    tasks.add(new EventTask(reported));
    assertThat(reported.await(10, TimeUnit.SECONDS)).as("the event was reported").isTrue();
    assertThat(begun).hasValue(RegistrarTaskManager.THREADS);
  }
}
