package org.dfra.cli.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.report.terminal.CommandFailure;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ListeningSessionTest {

  private static final Duration LONG = Duration.ofSeconds(50);

  private final Talker talker = new Talker();

  ListeningSessionTest() {
    talker.start();
  }

  @AfterEach
  void end() {
    talker.close();
  }

  /** Records the events that it receives, until there are so many. */
  private static final class Recorder implements ListeningSession.EventHandler {
    final List<Delivery> received = new CopyOnWriteArrayList<>();
    final int wanted;

    Recorder(int wanted) {
      this.wanted = wanted;
    }

    @Override
    public boolean onEvent(Delivery delivery, long lost) {
      received.add(delivery);
      return received.size() < wanted;
    }

    @Override
    public boolean onSecond(long lost) {
      return true;
    }
  }

  private CompletableFuture<Long> listen(Recorder recorder, long count, Duration time) {
    CompletableFuture<Long> run =
        CompletableFuture.supplyAsync(
            () -> {
              try (ListeningSession listening =
                  new ListeningSession(talker.listing(), recorder, count)) {
                return listening.run(
                    DeliveryPolicy.keepLast(100).withKinds(EventKind.READING), time);
              } catch (java.rmi.RemoteException | InterruptedException e) {
                throw new IllegalStateException(e);
              }
            },
            task -> new Thread(task, "listening").start());
    await().atMost(LONG).until(() -> run.isDone() || talker.leases().clients() == 1);
    return run;
  }

  @Test
  void endsAfterSoManyEventsAndGivesItsLeaseBack() throws Exception {
    Recorder recorder = new Recorder(Integer.MAX_VALUE);
    CompletableFuture<Long> run = listen(recorder, 2, LONG);
    for (int i = 0; i < 5; i++) {
      talker.say(i);
    }
    assertThat(run.get()).isZero();
    assertThat(recorder.received).hasSize(2);
    assertThat(talker.leases().clients()).isZero();
    assertThat(talker.events().entries()).isEmpty();
  }

  @Test
  void endsWhenNobodyWantsMore() throws Exception {
    Recorder recorder = new Recorder(1);
    CompletableFuture<Long> run = listen(recorder, Long.MAX_VALUE, LONG);
    talker.say(1);
    assertThat(run.get()).isZero();
    assertThat(recorder.received).hasSize(1);
  }

  @Test
  void endsWhenTheTimeIsOver() throws Exception {
    assertThat(listen(new Recorder(1), 1, Duration.ofMillis(50)).get()).isZero();
    assertThat(talker.leases().clients()).isZero();
  }

  @Test
  void saysSoWhenItsLeaseIsRevoked() {
    CompletableFuture<Long> run = listen(new Recorder(1), 1, LONG);
    assertThat(talker.leases().revoke(talker.leases().leases().get(0).handle())).isTrue();
    assertThat(talker.events().entries()).as("no events are sent to it any more").isEmpty();
    assertThatThrownBy(run::get)
        .isInstanceOf(ExecutionException.class)
        .cause()
        .isInstanceOf(CommandFailure.class)
        .hasMessage("atrv1/talker sends no more events: an administrator has revoked the lease");
  }

  @Test
  void eventsArePrintedOnOneLine() {
    assertThat(words(new ModuleEvent.NewReading(new Talker.Word(Instant.EPOCH, 0.5)), 0))
        .isEqualTo(
            "2026-11-21T12:58:04.123Z  reading    #7  Word measured 1970-01-01T00:00:00Z, loudness"
                + " 0.5");
    assertThat(words(new ModuleEvent.ReadinessChanged(Readiness.READY, Readiness.ACTIVE), 3))
        .isEqualTo("2026-11-21T12:58:04.123Z  readiness  #7  ready -> active  (3 lost before)");
    assertThat(words(new ModuleEvent.ParameterChanged("rate", "5"), 0)).endsWith("rate is now 5");
    assertThat(
            words(
                new ModuleEvent.IncidentRecorded(
                    new Incident(Instant.EPOCH, Incident.Kind.FAILURE, "its cable was cut")),
                0))
        .endsWith("incident   #7  failure: its cable was cut");
  }

  private static String words(ModuleEvent event, long lost) {
    Delivery delivery =
        new Delivery("atrv1/talker", 1, 7, 0, Instant.parse("2026-11-21T12:58:04.123456Z"), event);
    assertThat(EventLine.of(delivery, lost).kind()).isEqualTo(EventKind.of(event));
    return EventLine.of(delivery, lost).inWords();
  }
}
