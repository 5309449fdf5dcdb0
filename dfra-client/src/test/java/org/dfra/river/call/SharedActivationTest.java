package org.dfra.river.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

/** What many callers of one dead object do to each other. */
class SharedActivationTest extends ResurrectionFixture {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @Test
  void callersThatShareAProxyShareOneActivation() throws Exception {
    CountDownLatch answer = new CountDownLatch(1);
    id.activating =
        force -> {
          await("answer").atMost(PATIENCE).until(() -> answer.getCount() == 0);
          return ResurrectingExporter.proxy(id, live("new"));
        };
    Service service = proxy(gone());
    List<Future<String>> callers = new ArrayList<>();
    for (int i = 0; i < 32; i++) {
      callers.add(threads.submit(service::read));
    }
    await("the activator is asked").atMost(PATIENCE).until(() -> !id.asked.isEmpty());
    answer.countDown();
    for (Future<String> each : callers) {
      assertThat(each.get()).isEqualTo("new");
    }
    assertThat(id.asked).as("activations for 32 callers").hasSize(1);
  }

  @Test
  void interruptedCallerSpoilsNothingForTheOthers() throws Exception {
    CountDownLatch answer = new CountDownLatch(1);
    id.activating =
        force -> {
          try {
            answer.await();
          } catch (InterruptedException e) {
            throw new RemoteException("the shared activation was interrupted", e);
          }
          return ResurrectingExporter.proxy(id, live("new"));
        };
    Service service = proxy(gone());
    AtomicReference<Exception> first = new AtomicReference<>();
    Thread impatient =
        new Thread(
            () -> {
              try {
                service.read();
              } catch (RemoteException e) {
                first.set(e);
              }
            });
    impatient.start();
    await("the activator is asked").atMost(PATIENCE).until(() -> !id.asked.isEmpty());
    Future<String> patient = threads.submit(service::read);
    impatient.interrupt();
    impatient.join(PATIENCE.toMillis());
    assertThat(first.get()).isInstanceOf(CallInterruptedException.class);
    answer.countDown();
    assertThat(patient.get()).isEqualTo("new");
    assertThat(id.asked).hasSize(1);
  }

  @Test
  void callerThatNeedsForceIsNotPutOffWithAnActivationWithoutIt() throws Exception {
    ConnectException dead = new ConnectException("dead");
    CountDownLatch unforced = new CountDownLatch(1);
    CountDownLatch slow = new CountDownLatch(1);
    id.activating =
        force -> {
          if (force) {
            return ResurrectingExporter.proxy(id, live("new"));
          }
          if (unforced.getCount() == 0) {
            return ResurrectingExporter.proxy(id, live("stale", dead, dead, dead));
          }
          unforced.countDown();
          await("release").atMost(PATIENCE).until(() -> slow.getCount() == 0);
          return ResurrectingExporter.proxy(id, live("stale", dead, dead, dead));
        };
    Service service = proxy(live("stale", dead, dead, dead, dead));
    Future<String> first = threads.submit(service::read);
    unforced.await();
    Future<String> second = threads.submit(service::read);
    slow.countDown();
    assertThat(first.get()).isEqualTo("new");
    assertThat(second.get()).isEqualTo("new");
  }

  @Test
  void manyCallersOfADyingObjectAllGetThrough() throws Exception {
    ConnectException dead = new ConnectException("dead");
    Service service = proxy(live("old", Collections.nCopies(200, dead).toArray(Throwable[]::new)));
    id.activating =
        force ->
            ResurrectingExporter.proxy(
                id,
                force
                    ? live("new")
                    : live("old", Collections.nCopies(200, dead).toArray(Throwable[]::new)));
    Callable<String> call = service::read;
    for (Future<String> each : threads.invokeAll(Collections.nCopies(64, call))) {
      assertThat(each.get()).isEqualTo("new");
    }
  }
}
