package org.dfra.core.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import org.dfra.core.lease.SteppedScheduler;
import org.dfra.core.state.StateStore;
import org.dfra.module.History;
import org.dfra.module.Incident.Kind;
import org.junit.jupiter.api.Test;
import org.slf4j.helpers.NOPLogger;

class HistoryBookTest {

  private final StateStore state = StateStore.inMemory();
  private final SteppedScheduler time = new SteppedScheduler();

  private HistoryBook book() {
    return new HistoryBook(
        "atrv1/lamp",
        state,
        InstantSource.fixed(Instant.EPOCH),
        time,
        Runnable::run,
        NOPLogger.NOP_LOGGER);
  }

  @Test
  void countsThroughAllLivesAndTakesAnEndWithoutCloseForAFailure() {
    HistoryBook first = book();
    first.begin();
    first.serving(true);
    time.step(Duration.ofSeconds(60));
    first.note(Kind.FAILURE, "its cable was cut");
    first.serving(false);
    time.step(Duration.ofSeconds(10));
    first.note(Kind.EXCEPTION, "garbage");

    HistoryBook second = book(); // the first was never closed
    second.begin();
    History history = second.history();
    assertThat(history.activations()).isEqualTo(2);
    assertThat(history.failures()).isEqualTo(2);
    assertThat(history.exceptions()).isEqualTo(1);
    assertThat(history.served()).isEqualTo(Duration.ofSeconds(60));
    assertThat(history.meanTimeBetweenFailures()).hasValue(Duration.ofSeconds(30));
    assertThat(history.recent().get(3).what()).contains("ended without being closed");

    second.note(Kind.DEACTIVATION, "it was closed");
    HistoryBook third = book();
    third.begin();
    assertThat(third.history().failures()).isEqualTo(2);
  }

  @Test
  void remembersTheLastHundredAndCountsAll() {
    HistoryBook book = book();
    book.begin();
    for (int i = 0; i < 250; i++) {
      book.note(Kind.EXCEPTION, "number " + i);
    }
    assertThat(book.history().exceptions()).isEqualTo(250);
    assertThat(book.history().recent()).hasSize(100);
    assertThat(book.history().recent().get(99).what()).isEqualTo("number 249");
  }

  @Test
  void beginsAnewWhereWhatIsKeptIsDamaged() throws Exception {
    state.write("history", new byte[] {1, 2, 3});
    HistoryBook book = book();
    book.begin();
    assertThat(book.history().activations()).isEqualTo(1);
    assertThat(book.history().failures()).isZero();
  }
}
