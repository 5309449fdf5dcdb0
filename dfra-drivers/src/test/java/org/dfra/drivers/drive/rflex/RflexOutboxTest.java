package org.dfra.drivers.drive.rflex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.drivers.fixture.Modules.await;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import org.dfra.drivers.link.Ticker;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The frames are letters; the line takes one when the test lets it. */
@Timeout(120)
class RflexOutboxTest {

  private final List<String> sent = new CopyOnWriteArrayList<>();
  private final Semaphore line = new Semaphore(0);
  private final RflexOutbox outbox = new RflexOutbox("test", Ticker.system(), this::take);

  private void take(byte[] frame) {
    line.acquireUninterruptibly();
    sent.add(new String(frame));
  }

  private static byte[] frame(String envelope) {
    return envelope.getBytes();
  }

  @AfterEach
  void close() {
    line.release(10_000);
    outbox.close();
    assertThat(Thread.getAllStackTraces().keySet())
        .noneMatch(thread -> thread.getName().equals("test writer"));
  }

  /** The writer holds the first frame, which the line does not take. */
  private void stuck() {
    outbox.start();
    outbox.add(frame("s"));
    await().until(() -> line.hasQueuedThreads());
  }

  private void expect(String... frames) {
    line.release(frames.length);
    await().until(() -> sent.size() >= frames.length);
    assertThat(sent).containsExactly(frames);
  }

  @Test
  void ofVelocitiesOnlyTheNewestWaits() {
    stuck();
    for (int i = 0; i < 1000; i++) {
      outbox.velocity(frame("old"), frame("older"));
    }
    outbox.velocity(frame("t"), frame("r"));
    expect("s", "t", "r");
  }

  @Test
  void aHaltTakesTheirPlaceAndGoesBeforeEverythingElse() {
    stuck();
    outbox.add(frame("b"));
    outbox.velocity(frame("old"), frame("older"));
    outbox.halt(frame("T"), frame("R"));
    outbox.add(frame("c"));
    expect("s", "T", "R", "b", "c", "T", "R", "T", "R");
  }

  @Test
  void aVelocityIsSentAfterEarlierCommands() {
    stuck();
    outbox.add(frame("release"));
    outbox.velocity(frame("t"), frame("r"));
    expect("s", "release", "t", "r");
  }

  @Test
  void aVelocityAfterAHaltTakesItsPlace() {
    stuck();
    outbox.halt(frame("T"), frame("R"));
    outbox.velocity(frame("t"), frame("r"));
    expect("s", "t", "r");
  }

  @Test
  void noAxisIsKeptBackByVelocitiesThatComeFasterThanTheyAreSent() {
    stuck();
    for (int i = 0; i < 6; i++) {
      outbox.velocity(frame("t"), frame("r"));
      line.release();
      int count = i + 1;
      await().until(() -> sent.size() == count && line.hasQueuedThreads());
    }
    assertThat(sent).containsExactly("s", "t", "r", "t", "r", "t");
  }

  @Test
  void discardsWhatCannotBeSent() {
    stuck();
    outbox.velocity(frame("t"), frame("r"));
    outbox.add(frame("b"));
    outbox.clear();
    outbox.add(frame("c"));
    expect("s", "c");
  }

  @Test
  void sendsWhatWaitsBeforeItEnds() throws Exception {
    outbox.start();
    line.release(100);
    outbox.halt(frame("T"), frame("R"));
    outbox.add(frame("b"));
    outbox.close();
    assertThat(sent).hasSize(7).startsWith("T", "R", "b");
  }

  @Test
  void aCallerNeverWaitsForTheLine() {
    stuck();
    long before = sent.size();
    for (int i = 0; i < 100; i++) {
      outbox.velocity(frame("t"), frame("r"));
      outbox.halt(frame("T"), frame("R"));
    }
    assertThat(sent).hasSize((int) before); // and this line was reached
  }

  @Test
  void closedBeforeItWasStartedItNeverStarts() {
    outbox.close();
    outbox.start();
    outbox.add(frame("x"));
    assertThat(sent).isEmpty();
  }
}
