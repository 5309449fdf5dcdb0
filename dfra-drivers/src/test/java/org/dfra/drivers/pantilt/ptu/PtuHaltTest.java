package org.dfra.drivers.pantilt.ptu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.beside;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.PanTiltCommand.PointAt;
import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.Test;

/** What brings the head to rest and keeps it there, also past a write that hangs. */
class PtuHaltTest extends PtuFixture {

  @Test
  void haltsPastAWriteThatHangsAndOnceMoreAfterIt() throws Exception {
    beReady();
    CommandLease lease = unit.acquireCommandLease(Duration.ofSeconds(10));
    CountDownLatch release = new CountDownLatch(1);
    link.holdUpAWrite(release);
    CompletableFuture<Void> writing =
        beside(() -> unit.execute(lease.key(), new PointAt(0.1, 0, 1)));
    try {
      await().until(() -> written().stream().anyMatch(each -> each.startsWith("PS")));
      assertThat(unit.emergencyStop("ops").latched()).isTrue();
      await().until(() -> written().contains("H "));
      assertThat(writing).isNotDone();
      settle(); // the reader does not wait for the write either
    } finally {
      release.countDown();
    }
    writing.get(60, TimeUnit.SECONDS);
    await().until(() -> written().stream().filter("H "::equals).count() == 2);
  }

  @Test
  void haltsPastAQuestionThatHangsAndOnceMoreAfterIt() throws Exception {
    beReady();
    CommandLease lease = unit.acquireCommandLease(Duration.ofSeconds(10));
    unit.execute(lease.key(), new PointAt(0.1, 0, 1));
    assertThat(next()).startsWith("PS");
    say("*\r\n*\r\n*\r\n*\r\n");
    CountDownLatch release = new CountDownLatch(1);
    link.holdUpTheReader(release);
    try {
      ticker.step(Duration.ofMillis(200));
      assertThat(next()).isEqualTo("PP ");
      assertThat(unit.emergencyStop("ops").latched()).isTrue();
      assertThat(next()).as("while the question hangs").isEqualTo("H ");
      await().until(() -> unit.emergencyStopState().haltCommanded());
    } finally {
      release.countDown();
    }
    assertThat(next()).as("after it").isEqualTo("H ");
    say("*\r\n"); // the first halt was faster than the question
    awaitWords();
    setUp();
    poll(1, 1);
    awaitReadiness(Readiness.READY);
  }

  private List<String> written() {
    return link.written().stream()
        .map(each -> new String(each, StandardCharsets.US_ASCII))
        .toList();
  }

  @Test
  void doesNotResetUnderItsCommander() throws Exception {
    beReady();
    try (CommandLease unused = unit.acquireCommandLease(Duration.ofSeconds(10))) {
      assertThat(unit.recover("reset_by_moving").finding())
          .isEqualTo(
              "it moves the head, which a module in its own virtual machine commands; have its"
                  + " lease closed first");
    }
  }

  @Test
  void doesNotResetWhileItIsStoppedForAnEmergency() {
    beReady();
    assertThat(unit.emergencyStop("ops").latched()).isTrue();
    assertThat(unit.recover("reset_by_moving").finding())
        .isEqualTo("it moves the head, which is stopped for an emergency; release it first");
  }
}
