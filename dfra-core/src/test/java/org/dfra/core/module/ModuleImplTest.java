package org.dfra.core.module;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import org.dfra.core.config.Parameters;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class ModuleImplTest {

  private static final Duration LONG = Duration.ofSeconds(25);

  /** A driver that notes what is asked of it. */
  private static class Lamp extends ModuleImpl {
    final List<String> calls = new CopyOnWriteArrayList<>();
    Runnable onStart = () -> {};
    Runnable onClose = () -> {};

    Lamp() {
      super(
          new ModuleContext(
              "atrv1",
              "lamp",
              Parameters.of("atrv1/lamp", Map.of()),
              InstantSource.fixed(Instant.EPOCH)),
          "a lamp",
          "DFRA",
          "1");
    }

    @Override
    protected void onStart() {
      calls.add("onStart");
      onStart.run();
      calls.add("started");
    }

    @Override
    protected void onClose() {
      calls.add("onClose");
      onClose.run();
    }

    void move(Readiness next) {
      transitionTo(next);
    }
  }

  private final Lamp lamp = new Lamp();

  /** Runs a task on a thread of its own and returns once that thread waits for something. */
  private static <T> FutureTask<T> waiting(Callable<T> task) {
    FutureTask<T> future = new FutureTask<>(task);
    Thread thread = new Thread(future, "waiting");
    thread.setDaemon(true);
    thread.start();
    await()
        .atMost(LONG)
        .until(
            () ->
                thread.getState() == Thread.State.TIMED_WAITING
                    || thread.getState() == Thread.State.WAITING);
    return future;
  }

  @Test
  void constructionOnlyAssigns() {
    assertThat(lamp.readiness()).isEqualTo(Readiness.CREATED);
    assertThat(lamp.calls).isEmpty();
    assertThat(lamp.identification())
        .isEqualTo(new Identification("atrv1", "lamp", "a lamp", "DFRA", "1"));
    assertThat(lamp).hasToString("atrv1/lamp (Lamp)");
    assertThat(lamp.clock().instant()).isEqualTo(Instant.EPOCH);
    assertThat(lamp.settings().all()).isEmpty();
  }

  @Test
  void startsOnceAndClosesOnce() {
    lamp.start();
    lamp.start();
    assertThat(lamp.readiness()).isEqualTo(Readiness.INITIALIZING);
    lamp.close();
    lamp.close();
    lamp.start();

    assertThat(lamp.readiness()).isEqualTo(Readiness.STOPPED);
    assertThat(lamp.calls).containsExactly("onStart", "started", "onClose");
  }

  @Test
  void aCloseBeforeAnyStartUndoesNothing() {
    lamp.close();
    lamp.start();

    assertThat(lamp.readiness()).isEqualTo(Readiness.STOPPED);
    assertThat(lamp.calls).isEmpty();
  }

  @Test
  void aStartThatThrowsLeavesTheModuleFailedAndStillToBeClosed() {
    lamp.onStart =
        () -> {
          throw new IllegalStateException("no such port");
        };

    assertThatThrownBy(lamp::start).hasMessage("no such port");
    assertThat(lamp.readiness()).isEqualTo(Readiness.FAILED);
    assertThatCode(lamp::start).as("a second start").doesNotThrowAnyException();
    lamp.close();

    assertThat(lamp.readiness()).isEqualTo(Readiness.STOPPED);
    assertThat(lamp.calls).containsExactly("onStart", "onClose");
  }

  @Test
  void aStartThatLacksAClassLeavesTheModuleFailedToo() {
    lamp.onStart =
        () -> {
          throw new NoClassDefFoundError("com/fazecast/jSerialComm/SerialPort");
        };

    assertThatThrownBy(lamp::start).isInstanceOf(NoClassDefFoundError.class);
    assertThat(lamp.readiness()).isEqualTo(Readiness.FAILED);
  }

  @Test
  void aCloseThatThrowsHasStoppedTheModule() {
    lamp.onClose =
        () -> {
          throw new IllegalStateException("stuck");
        };
    lamp.start();

    assertThatThrownBy(lamp::close).hasMessage("stuck");
    assertThat(lamp.readiness()).isEqualTo(Readiness.STOPPED);
    assertThatCode(lamp::close).doesNotThrowAnyException();
  }

  @Test
  void aCloseDuringTheStartStopsAtOnceAndUndoesAfterIt() throws Exception {
    CountDownLatch opening = new CountDownLatch(1);
    CountDownLatch opened = new CountDownLatch(1);
    lamp.onStart =
        () -> {
          opening.countDown();
          awaitLatch(opened);
          lamp.move(Readiness.READY);
        };
    CompletableFuture<Void> start = CompletableFuture.runAsync(lamp::start);
    awaitLatch(opening);

    FutureTask<Readiness> close =
        waiting(
            () -> {
              lamp.close();
              return lamp.readiness();
            });
    await().atMost(LONG).until(() -> lamp.readiness() == Readiness.STOPPED);
    assertThat(lamp.calls).containsExactly("onStart");
    opened.countDown();

    assertThat(close.get(25, SECONDS)).isEqualTo(Readiness.STOPPED);
    start.get(25, SECONDS);
    assertThat(lamp.calls).containsExactly("onStart", "started", "onClose");
  }

  @Test
  void aDriverThreadMayCloseWhileAnotherClosesIt() throws Exception {
    lamp.start();
    lamp.onClose = () -> CompletableFuture.runAsync(lamp::close).join();

    CompletableFuture.runAsync(lamp::close).get(25, SECONDS);

    assertThat(lamp.calls).containsExactly("onStart", "started", "onClose");
  }

  @Test
  void aMoveToWhereItIsDoesNothing() {
    lamp.start();

    assertThatCode(() -> lamp.move(Readiness.INITIALIZING)).doesNotThrowAnyException();
  }

  @Test
  void anIllegalMoveIsRefusedByName() {
    lamp.start();
    assertThatThrownBy(() -> lamp.move(Readiness.ACTIVE))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("atrv1/lamp cannot go from INITIALIZING to ACTIVE");
    lamp.move(Readiness.READY);
    assertThatThrownBy(() -> lamp.move(Readiness.CREATED))
        .hasMessage("atrv1/lamp cannot go from READY to CREATED");

    assertThat(lamp.readiness()).isEqualTo(Readiness.READY);
  }

  @Test
  void aDriverThatLearnsOfTheCloseTooLateIsNotBlamed() {
    lamp.start();
    lamp.close();

    assertThatCode(() -> lamp.move(Readiness.READY)).doesNotThrowAnyException();
    assertThat(lamp.readiness()).isEqualTo(Readiness.STOPPED);
  }

  @Test
  void awaitReadinessWakesWhenTheModuleServes() throws Exception {
    lamp.start();
    FutureTask<Readiness> waiter = waiting(() -> lamp.awaitReadiness(LONG));

    lamp.move(Readiness.READY);

    assertThat(waiter.get(20, SECONDS)).isEqualTo(Readiness.READY);
  }

  @Test
  void awaitReadinessWakesWhenThereIsNoHopeLeft() throws Exception {
    lamp.start();
    FutureTask<Readiness> failed = waiting(() -> lamp.awaitReadiness(LONG));
    lamp.move(Readiness.FAILED);
    assertThat(failed.get(20, SECONDS)).isEqualTo(Readiness.FAILED);

    lamp.move(Readiness.INITIALIZING);
    FutureTask<Readiness> stopped = waiting(() -> lamp.awaitReadiness(LONG));
    lamp.close();
    assertThat(stopped.get(20, SECONDS)).isEqualTo(Readiness.STOPPED);
  }

  @Test
  void awaitReadinessEndsWithThePatience() {
    lamp.start();

    assertThat(lamp.awaitReadiness(Duration.ofMillis(20))).isEqualTo(Readiness.INITIALIZING);
    assertThat(lamp.awaitReadiness(Duration.ZERO)).isEqualTo(Readiness.INITIALIZING);
  }

  @Test
  void awaitReadinessTakesAnyPatience() {
    lamp.start();
    lamp.move(Readiness.READY);

    assertThat(lamp.awaitReadiness(Duration.ofSeconds(Long.MAX_VALUE))).isEqualTo(Readiness.READY);
  }

  @Test
  void awaitReadinessEndsWhenInterruptedAndSaysSo() {
    lamp.start();
    Thread.currentThread().interrupt();

    assertThat(lamp.awaitReadiness(LONG)).isEqualTo(Readiness.INITIALIZING);
    assertThat(Thread.interrupted()).as("the interrupt is handed on").isTrue();
  }

  private static void awaitLatch(CountDownLatch latch) {
    try {
      assertThat(latch.await(25, SECONDS)).as("the other thread came this far").isTrue();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void saysWhyItDoesNotServe() {
    assertThat(lamp.notReadyReason()).contains("it has not been started");
    lamp.start();
    assertThat(lamp.notReadyReason()).contains("its first data have not come yet");
    lamp.transitionTo(Readiness.FAILED, "its bulb is broken");
    assertThat(lamp.notReadyReason()).contains("its bulb is broken");
    lamp.move(Readiness.INITIALIZING);
    lamp.move(Readiness.READY);
    assertThat(lamp.notReadyReason()).isEmpty();
    lamp.close();
    assertThat(lamp.notReadyReason()).contains("it has ended");
  }
}
