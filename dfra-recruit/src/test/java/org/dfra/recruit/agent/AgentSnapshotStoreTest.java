package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.core.config.Parameters;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.core.time.ScaledTime;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.requester.RequesterMachine;
import org.dfra.recruit.requester.RequesterState;
import org.dfra.recruit.responder.ResponderMachine;
import org.dfra.recruit.responder.ResponderMachine.ResponderPolicy;
import org.dfra.recruit.responder.ResponderState;
import org.dfra.recruit.strategy.Greedy;
import org.dfra.recruit.transport.VirtualTime;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What of an agent is known again, and what not, by boots and clocks. */
class AgentSnapshotStoreTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T00:00:00Z");
  private static final HelpCall CALL =
      new HelpCall(
          "mine", new GeoPosition(28, -82, 0), Duration.ofSeconds(20), Duration.ofSeconds(60));

  private final StateStore state = StateStore.inMemory();
  private final VirtualTime time = new VirtualTime(Instant.EPOCH); // since boot
  private Instant wall = BEGIN;
  private BootId boot;

  @TempDir Path folder;

  @BeforeEach
  void boot() throws IOException {
    boot = boot("1b9d6bcd");
  }

  private BootId boot(String id) throws IOException {
    return new BootId(Files.writeString(folder.resolve(id), id));
  }

  private AgentSnapshotStore memory(InstantSource clock, BootId in) {
    return new AgentSnapshotStore(
        new ModuleContext(
            "ugv1",
            "recruit",
            Parameters.of("ugv1/recruit", Map.of()),
            clock,
            state,
            LeaseTerms.DEFAULT,
            time),
        in);
  }

  private AgentSnapshotStore memory(BootId in) {
    return memory(() -> wall, in);
  }

  /** It calls for help in ugv1#8, and is on its way to help in uav#5. */
  private static AgentSnapshot busy(Instant now) {
    RequesterState calling =
        new RequesterMachine(RecruitmentSettings.DEFAULT, new Greedy())
            .call(RequesterState.idle(new Conversation("ugv1", 7)), CALL, now)
            .state();
    return new AgentSnapshot(calling, travelling(now), 0.7);
  }

  private static ResponderMachine machine() {
    ResponderPolicy willing =
        new ResponderPolicy() {
          @Override
          public Optional<Offer> offer(HelpCall call) {
            return Optional.of(new Offer(Duration.ofSeconds(10), 1));
          }

          @Override
          public boolean shouldOffer(Help help, Offer offer) {
            return true;
          }

          @Override
          public boolean sendsRefusal() {
            return false;
          }
        };
    return new ResponderMachine("ugv1", RecruitmentSettings.DEFAULT, willing);
  }

  private static ResponderState travelling(Instant now) {
    ResponderMachine machine = machine();
    Conversation in = new Conversation("uav", 5);
    ResponderState offered =
        machine.receive(ResponderState.FREE, new Help(in, CALL, 1), now).state();
    return machine.receive(offered, new ResponderId(in, "ugv1", 0), now).state();
  }

  /** The file is of commit 5b8faecf, with a release to repeat and a record of a requester. */
  @Test
  void aSnapshotFromBeforeClassesWereRenamedIsLoaded() throws IOException {
    try (InputStream in = getClass().getResourceAsStream("recorded-snapshot.bin")) {
      state.write("recruitment", in.readAllBytes());
    }
    time.advance(Duration.ofSeconds(5)); // it was stored 1 µs after the boot
    AgentSnapshot loaded = memory(boot).load().orElseThrow();
    assertThat(loaded.urge()).isEqualTo(0.25);
    assertThat(loaded.requester().conversation()).isEqualTo(new Conversation("ugv1", 8));
    assertThat(loaded.requester())
        .asString()
        .contains("PendingRelease[conversation=" + new Conversation("ugv1", 7) + ", robot=ugv2");
    assertThat(loaded.responder())
        .asString()
        .contains("{uav=ConversationRecord[closed=3, completed=2, lastCall=5, round=1]}");
  }

  @ParameterizedTest
  @ValueSource(ints = {-3600, 0, 3600})
  void inTheSameBootEverythingIsKnownAndTheClockGoesOn(int set) throws IOException {
    AgentSnapshotStore before = memory(boot);
    time.advance(Duration.ofSeconds(5));
    AgentSnapshot kept = busy(before.clock().instant());
    before.save(kept);
    time.advance(Duration.ofSeconds(3));
    wall = wall.plusSeconds(8 + set);
    AgentSnapshotStore after = memory(boot);
    assertThat(after.load()).contains(kept);
    assertThat(after.clock().instant()).isEqualTo(BEGIN.plusSeconds(8));
    time.advance(Duration.ofSeconds(2));
    assertThat(after.clock().instant()).isEqualTo(BEGIN.plusSeconds(10));
  }

  @Test
  void afterAnotherBootOnlyWhatMustNotBeRepeatedIsKnown() throws IOException {
    AgentSnapshotStore before = memory(boot);
    AgentSnapshot kept = busy(before.clock().instant());
    assertThat(kept.requester().phase()).isEqualTo(RequesterPhase.CALLING);
    assertThat(kept.responder().phase()).isEqualTo(ResponderPhase.TRAVELLING);
    before.save(kept);
    time.advance(Duration.ofSeconds(1));
    for (BootId other : new BootId[] {boot("77aa"), new BootId(folder.resolve("nowhere"))}) {
      AgentSnapshot known = memory(other).load().orElseThrow();
      assertThat(known.requester()).isEqualTo(RequesterState.idle(new Conversation("ugv1", 8)));
      assertThat(known.responder().phase()).isEqualTo(ResponderPhase.FREE);
      assertThat(known.responder().nextWake()).isEqualTo(Instant.MAX);
      assertThat(known.urge()).isZero();
      assertThat(
              machine()
                  .receive(
                      known.responder(),
                      new ResponderId(new Conversation("uav", 5), "ugv1", 0),
                      BEGIN)
                  .state()
                  .phase())
          .as("it is chosen again where it was on its way before")
          .isEqualTo(ResponderPhase.FREE);
    }
  }

  /** Messages are numbered by it. */
  @Test
  void afterAnotherBootTheClockDoesNotGoBack() throws IOException {
    AgentSnapshotStore before = memory(boot);
    before.save(busy(BEGIN));
    wall = Instant.EPOCH; // it has no battery, and its receiver no fix yet
    AgentSnapshotStore after = memory(boot("77aa"));
    assertThat(after.load()).isPresent();
    assertThat(after.clock().instant()).isEqualTo(BEGIN);
    wall = BEGIN.plusSeconds(60);
    after = memory(boot("78aa"));
    assertThat(after.load()).isPresent();
    assertThat(after.clock().instant()).isEqualTo(wall);
  }

  @Test
  void aBootThatCannotBeReadIsNotTakenForAnother() throws IOException {
    memory(boot).save(busy(BEGIN));
    Path file = Files.createDirectory(folder.resolve("boot_id")); // it is there, but not readable
    AgentSnapshotStore after = memory(new BootId(file));
    assertThatThrownBy(after::load).isInstanceOf(IOException.class);
    Files.delete(file);
    Files.writeString(file, "1b9d6bcd");
    assertThat(after.load()).contains(busy(BEGIN));
  }

  @Test
  void whereTheBootCannotBeReadWhatMustNotBeRepeatedIsKnown() throws IOException {
    memory(boot).save(busy(BEGIN));
    Path file = Files.createDirectory(folder.resolve("boot_id"));
    wall = BEGIN.minusSeconds(60);
    AgentSnapshotStore after = memory(new BootId(file));
    assertThat(after.loadWithoutTimers()).contains(busy(BEGIN).afterAnotherBoot());
    assertThat(after.clock().instant()).as("messages are numbered by it").isEqualTo(BEGIN);
  }

  @Test
  void theTimeOfASimulationGoesOnAtItsSpeedAndNoOtherDoes() throws IOException {
    String four = "4x since 2026-11-21T00:00:00Z";
    AgentSnapshotStore before = memory(ScaledTime.parse(four), boot);
    Instant began = before.clock().instant();
    AgentSnapshot kept = busy(began);
    before.save(kept);
    time.advance(Duration.ofHours(1)); // the processes' own four seconds in each do not matter
    AgentSnapshotStore after = memory(ScaledTime.parse(four), boot);
    assertThat(after.load()).contains(kept);
    assertThat(after.clock().instant())
        .isBetween(began.plus(Duration.ofHours(4)), began.plus(Duration.ofHours(5)));
    AgentSnapshotStore other = memory(ScaledTime.parse("2x since 2026-11-21T00:00:00Z"), boot);
    assertThat(other.load()).contains(kept.afterAnotherBoot());
  }
}
