package org.dfra.core.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import org.dfra.core.lease.SteppedScheduler;
import org.dfra.core.state.StateStore;
import org.dfra.lifecycle.Incident.Kind;
import org.dfra.module.ModuleHistory;
import org.junit.jupiter.api.Test;
import org.slf4j.helpers.NOPLogger;

class IncidentLogTest {

  private final StateStore state = StateStore.inMemory();
  private final SteppedScheduler time = new SteppedScheduler();

  private IncidentLog book() {
    return new IncidentLog(
        "atrv1/lamp",
        state,
        InstantSource.fixed(Instant.EPOCH),
        time,
        Runnable::run,
        NOPLogger.NOP_LOGGER);
  }

  @Test
  void countsThroughAllLivesAndTakesAnEndWithoutCloseForAFailure() {
    IncidentLog first = book();
    first.beginLife();
    first.setServing(true);
    time.step(Duration.ofSeconds(60));
    first.record(Kind.FAILURE, "its cable was cut");
    first.setServing(false);
    time.step(Duration.ofSeconds(10));
    first.record(Kind.EXCEPTION, "garbage");

    IncidentLog second = book(); // the first was never closed
    second.beginLife();
    ModuleHistory history = second.history();
    assertThat(history.activations()).isEqualTo(2);
    assertThat(history.failures()).isEqualTo(2);
    assertThat(history.exceptions()).isEqualTo(1);
    assertThat(history.servingTime()).isEqualTo(Duration.ofSeconds(60));
    assertThat(history.meanTimeBetweenFailures()).hasValue(Duration.ofSeconds(30));
    assertThat(history.recent().get(3).description()).contains("ended without being closed");

    second.record(Kind.DEACTIVATION, "it was closed");
    IncidentLog third = book();
    third.beginLife();
    assertThat(third.history().failures()).isEqualTo(2);
  }

  @Test
  void remembersTheLastHundredAndCountsAll() {
    IncidentLog book = book();
    book.beginLife();
    for (int i = 0; i < 250; i++) {
      book.record(Kind.EXCEPTION, "number " + i);
    }
    assertThat(book.history().exceptions()).isEqualTo(250);
    assertThat(book.history().recent()).hasSize(100);
    assertThat(book.history().recent().get(99).description()).isEqualTo("number 249");
  }

  @Test
  void startsEmptyWhereTheStoredLogIsDamaged() throws Exception {
    state.write("history", new byte[] {1, 2, 3});
    IncidentLog book = book();
    book.beginLife();
    assertThat(book.history().activations()).isEqualTo(1);
    assertThat(book.history().failures()).isZero();
  }
}
