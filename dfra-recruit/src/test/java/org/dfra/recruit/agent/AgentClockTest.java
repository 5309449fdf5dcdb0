package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RequesterPhase;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.transport.VirtualTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** An agent whose computer's clock is set, or whose computer is restarted. */
class AgentClockTest {

  private static final HelpCall CALL =
      new HelpCall(
          "mine", new GeoPosition(28, -82, 0), Duration.ofSeconds(100), Duration.ofSeconds(60));

  private final VirtualTime time = new VirtualTime(Instant.parse("2026-11-21T00:00:00Z"));
  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time);
  private final StateStore kept = StateStore.inMemory();
  private final Map<RecruitmentAgentImpl, DirectoryRegistration> listed = new HashMap<>();
  private final List<MessageEnvelope> received = new ArrayList<>(); // by the other robot
  private Duration set = Duration.ZERO; // by how much somebody has set the wall clock

  @TempDir Path folder;

  private final RecruitmentAgentImpl other =
      agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine"));

  @AfterEach
  void end() {
    List.copyOf(listed.keySet()).forEach(this::end);
    directory.close();
  }

  private ModuleContext context(String robot, StateStore state, Map<String, String> texts) {
    Parameters parameters = Parameters.of(robot + "/recruit", texts);
    return new ModuleContext(
            robot, "recruit", parameters, this::wall, state, LeaseTerms.DEFAULT, time)
        .withDirectory(directory);
  }

  private Instant wall() {
    return time.instant().plus(set);
  }

  private RecruitmentAgentImpl agent(String robot, StateStore state, Map<String, String> texts) {
    return agent(robot, state, texts, BootId.system());
  }

  private RecruitmentAgentImpl agent(
      String robot, StateStore state, Map<String, String> texts, BootId boot) {
    RecruitmentAgentImpl agent =
        new RecruitmentAgentImpl(
            context(robot, state, texts),
            new RecruiterListener() {
              @Override
              public void received(MessageEnvelope envelope) {
                received.add(envelope);
              }
            },
            boot);
    agent.start();
    listed.put(agent, directory.add(agent));
    time.advance(Duration.ofSeconds(1));
    return agent;
  }

  private void end(RecruitmentAgentImpl agent) {
    listed.remove(agent).close();
    agent.close();
  }

  private RecruitmentAgentImpl caller() {
    return agent("uav", kept, Map.of());
  }

  @ParameterizedTest
  @ValueSource(ints = {-3600, 3600})
  void aClockThatIsSetWhileItLivesChangesNothing(int seconds) {
    RecruitmentAgentImpl uav = caller();
    uav.callForHelp(CALL);
    time.advance(Duration.ofSeconds(10));
    set = Duration.ofSeconds(seconds);
    int before = received.size();
    time.advance(Duration.ofSeconds(45));
    assertThat(received.size()).as("it goes on calling").isGreaterThan(before);
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.CALLING);
    assertThat(received.get(received.size() - 1).time())
        .as("for people, by the clock as it is now")
        .isBetween(wall().minusSeconds(60), wall());
    time.advance(Duration.ofSeconds(10));
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
    assertThat(uav.status().measured()).isBetween(wall().minusSeconds(60), wall());
    assertThat(other.readiness().serves()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(ints = {-3600, 3600})
  void aClockThatIsSetBetweenItsLivesChangesNothing(int seconds) {
    RecruitmentAgentImpl uav = caller();
    uav.callForHelp(CALL);
    time.advance(Duration.ofSeconds(10));
    end(uav);
    long last = received.get(received.size() - 1).number();
    received.clear();
    set = Duration.ofSeconds(seconds);
    time.advance(Duration.ofSeconds(4));
    RecruitmentAgentImpl again = caller(); // 15 s of 60
    time.advance(Duration.ofSeconds(40));
    assertThat(again.status().requesterPhase()).isEqualTo(RequesterPhase.CALLING);
    assertThat(received).as("it goes on calling").isNotEmpty();
    assertThat(received.get(0).number()).as("numbers go on growing").isGreaterThan(last);
    time.advance(Duration.ofSeconds(10));
    assertThat(again.status().requesterPhase())
        .as("after its patience")
        .isEqualTo(RequesterPhase.IDLE);
    assertThat(again.status().lastChange()).contains("no robot offered to arrive in time");
  }

  @Test
  void aCallFromAnotherBootIsForgottenAndItsNumberIsNot() throws Exception {
    RecruitmentAgentImpl uav = caller();
    uav.callForHelp(CALL);
    time.advance(Duration.ofSeconds(2));
    end(uav);
    long conversation = received.get(0).message().conversation().number();
    BootId former = new BootId(Files.writeString(folder.resolve("boot_id"), "another"));
    AgentSnapshotStore writer = new AgentSnapshotStore(context("uav", kept, Map.of()), former);
    AgentSnapshot last =
        new AgentSnapshotStore(context("uav", kept, Map.of()), BootId.system())
            .load()
            .orElseThrow();
    writer.save(last);
    received.clear();
    RecruitmentAgentImpl again = caller();
    assertThat(last.requester().phase()).isEqualTo(RequesterPhase.CALLING);
    assertThat(again.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
    time.advance(Duration.ofSeconds(20));
    assertThat(received).as("it calls nobody by itself").isEmpty();
    again.callForHelp(CALL);
    time.advance(Duration.ofSeconds(1));
    assertThat(received.get(0).message().conversation().number()).isEqualTo(conversation + 1);
  }

  /** As in a shortage of file descriptors, which is over when it keeps its next state. */
  @Test
  void whereTheBootCannotBeReadTheNumberOfACallIsNotForgotten() throws Exception {
    Path file = Files.writeString(folder.resolve("boot_id"), "this one");
    RecruitmentAgentImpl uav = agent("uav", kept, Map.of(), new BootId(file));
    uav.callForHelp(CALL);
    time.advance(Duration.ofSeconds(2));
    end(uav);
    long conversation = received.get(0).message().conversation().number();
    received.clear();
    Files.delete(file);
    Files.createDirectory(file); // it is there, but not readable
    RecruitmentAgentImpl again = agent("uav", kept, Map.of(), new BootId(file));
    assertThat(again.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
    Files.delete(file);
    Files.writeString(file, "this one");
    again.callForHelp(CALL);
    time.advance(Duration.ofSeconds(1));
    assertThat(received.get(0).message().conversation().number()).isEqualTo(conversation + 1);
    end(again);
    received.clear();
    RecruitmentAgentImpl third = agent("uav", kept, Map.of(), new BootId(file));
    assertThat(third.status().requesterPhase()).as("it goes on").isEqualTo(RequesterPhase.CALLING);
    time.advance(Duration.ofSeconds(20));
    assertThat(received.get(0).message().conversation().number()).isEqualTo(conversation + 1);
  }
}
