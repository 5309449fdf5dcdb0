package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpCallRejectedException;
import org.dfra.agent.HelpCallRejectedException.Reason;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RequesterPhase;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.transport.VirtualTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The agent as a module: found by its persona, kept over its end, refused in sentences. */
class RecruitmentAgentImplTest {

  private static final GeoPosition HERE = new GeoPosition(28.06, -82.41, 0);

  private final VirtualTime time = new VirtualTime(Instant.parse("2026-11-21T00:00:00Z"));
  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time);
  private final StateStore kept = StateStore.inMemory();
  private final List<RecruitmentAgentImpl> made = new ArrayList<>();
  private final Map<RecruitmentAgentImpl, DirectoryRegistration> listed = new HashMap<>();
  private final List<MessageEnvelope> received = new ArrayList<>();

  @AfterEach
  void end() {
    made.forEach(RecruitmentAgentImpl::close);
    directory.close();
  }

  private RecruitmentAgentImpl agent(String robot, StateStore state, Map<String, String> texts) {
    ModuleContext context =
        new ModuleContext(robot, "recruit", Parameters.of(robot + "/recruit", texts), time, state)
            .withDirectory(directory);
    RecruitmentAgentImpl agent =
        new RecruitmentAgentImpl(
            context,
            new RecruiterListener() {
              @Override
              public void received(MessageEnvelope envelope) {
                received.add(envelope);
              }
            });
    made.add(agent);
    agent.start();
    listed.put(agent, directory.add(agent));
    return agent;
  }

  private static HelpCall call(String percept) {
    return new HelpCall(percept, HERE, Duration.ofSeconds(20), Duration.ofSeconds(60));
  }

  @Test
  void onlyThoseThatCanObserveItAreAsked() {
    RecruitmentAgentImpl uav = agent("uav", kept, Map.of());
    agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine, heat"));
    agent("ugv2", StateStore.inMemory(), Map.of("percepts", "heat"));
    time.advance(Duration.ofSeconds(1));
    uav.callForHelp(call("mine"));
    time.advance(Duration.ofSeconds(1));
    assertThat(received).as("one can observe mines").hasSize(1);
    assertThat(received.get(0).sender()).isEqualTo("uav");
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.CALLING);
    assertThatThrownBy(() -> uav.callForHelp(call("gold")))
        .isInstanceOf(HelpCallRejectedException.class);
    uav.release();
    assertThatThrownBy(() -> uav.callForHelp(call("gold")))
        .hasMessage(
            "no robot within reach of uav can observe \"gold\"; other robots observe heat, mine");
  }

  @Test
  void aRejectionHasAReasonForPrograms() {
    RecruitmentAgentImpl uav = agent("uav", kept, Map.of());
    assertThat(reason(uav, "mine")).isEqualTo(Reason.ALONE);
    agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine"));
    time.advance(Duration.ofSeconds(1));
    assertThat(reason(uav, "gold")).isEqualTo(Reason.NO_CAPABLE_ROBOT);
    uav.callForHelp(call("mine"));
    assertThat(reason(uav, "mine")).isEqualTo(Reason.NOT_READY);
  }

  private static Reason reason(RecruitmentAgentImpl agent, String percept) {
    return catchThrowableOfType(
            HelpCallRejectedException.class, () -> agent.callForHelp(call(percept)))
        .reason();
  }

  @Test
  void noneOfTwoRobotsOfOneNameIsAsked() {
    RecruitmentAgentImpl uav = agent("uav", kept, Map.of());
    agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine"));
    ModuleListing<RecruitmentAgent> one =
        directory.find(ModuleQuery.of(RecruitmentAgent.class).robot("ugv1")).get(0);
    directory.put(
        UUID.randomUUID(),
        one.module(),
        one.attributes().stream().map(each -> elsewhere(each)).toList(),
        Locality.REMOTE);
    time.advance(Duration.ofSeconds(1));
    assertThatThrownBy(() -> uav.callForHelp(call("mine")))
        .isInstanceOf(HelpCallRejectedException.class)
        .hasMessage(
            "uav does not call for help to observe \"mine\": 2 robots are named ugv1, on 10.0.0.6 and"
                + " localhost; give each robot a different name in its XML");
    assertThat(received).isEmpty();
  }

  private static Attributes elsewhere(Attributes one) {
    return one instanceof ModuleAttributes module
        ? new ModuleAttributes(
            module.robot(),
            module.name(),
            module.driver(),
            "10.0.0.6",
            module.author(),
            module.version(),
            module.state(),
            module.created(),
            module.activated(),
            module.clients())
        : one;
  }

  @Test
  void aCallOutlivesItsProcess() {
    agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine"));
    RecruitmentAgentImpl uav = agent("uav", kept, Map.of());
    time.advance(Duration.ofSeconds(1));
    uav.callForHelp(call("mine"));
    uav.close();
    made.remove(uav);
    listed.get(uav).close();
    time.advance(Duration.ofSeconds(4));
    long last = received.get(received.size() - 1).number();
    received.clear();
    RecruitmentAgentImpl again = agent("uav", kept, Map.of());
    assertThat(again.status().requesterPhase()).isEqualTo(RequesterPhase.CALLING);
    time.advance(Duration.ofSeconds(70));
    assertThat(received).as("it goes on calling").isNotEmpty();
    assertThat(received.get(0).number()).as("numbers go on growing").isGreaterThan(last);
    assertThat(again.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
    assertThat(again.status().lastChange()).contains("no robot offered to arrive in time");
  }

  /** Somebody may be on the way to help it, or wait for its help. */
  @Test
  void itFailsAndSaysSoWhereNothingCanBeReadOfWhatItKept(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("recruitment");
    byte[] damaged = {0, 1, 2, 3, 4, 5, 6, 7};
    Files.write(file, damaged);
    agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine"));
    RecruitmentAgentImpl uav = agent("uav", StateStore.inFolder(folder), Map.of());
    time.advance(Duration.ofSeconds(1));
    assertThat(uav.readiness()).isEqualTo(Readiness.FAILED);
    assertThat(uav.notReadyReason().orElseThrow())
        .startsWith("the stored state of its conversations, " + file + ", cannot be decoded: ")
        .endsWith(
            "; move that file away, which discards its call and its promises, and restart it:"
                + " ./dfra module stop uav/recruit, then ./dfra module start uav/recruit");
    assertThatThrownBy(() -> uav.callForHelp(call("mine"))).isInstanceOf(NotReadyException.class);
    assertThat(uav.status().lastChange()).isEqualTo(uav.notReadyReason().orElseThrow());
    assertThat(file).as("nothing is written over it").hasBinaryContent(damaged);
    listed.get(uav).close();
    uav.close();
    made.remove(uav);
    Files.delete(file);
    RecruitmentAgentImpl again = agent("uav", StateStore.inFolder(folder), Map.of());
    time.advance(Duration.ofSeconds(1));
    again.callForHelp(call("mine"));
    assertThat(again.status().requesterPhase()).isEqualTo(RequesterPhase.CALLING);
  }

  /** As for want of file descriptors: there is nothing wrong with the file. */
  @Test
  void itAsksOnlyForARestartWhereWhatItKeptCannotBeReadNow(@TempDir Path folder)
      throws IOException {
    Path file = Files.createDirectory(folder.resolve("recruitment")); // so reading fails
    RecruitmentAgentImpl uav = agent("uav", StateStore.inFolder(folder), Map.of());
    time.advance(Duration.ofSeconds(1));
    assertThat(uav.readiness()).isEqualTo(Readiness.FAILED);
    assertThat(uav.notReadyReason().orElseThrow())
        .startsWith("the stored state of its conversations, " + file + ", cannot be read: ")
        .endsWith(
            "; restart it when the file can be read: ./dfra module stop uav/recruit, then ./dfra module"
                + " start uav/recruit");
  }

  @Test
  void whatCannotBeIsRefusedWithItsPlace() {
    assertThatThrownBy(() -> agent("ugv1", kept, Map.of("strategy", "gredy")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("did you mean \"greedy\"?");
    assertThatThrownBy(() -> agent("ugv1", kept, Map.of("field", "28,-82 27,-81")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("two corners, south-west and north-east");
  }

  @Test
  void placesOutsideTheFieldAreRefused() {
    agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine"));
    RecruitmentAgentImpl uav = agent("uav", kept, Map.of("field", "28.10,-82.42 28.11,-82.41"));
    time.advance(Duration.ofSeconds(1));
    assertThatThrownBy(() -> uav.callForHelp(call("mine")))
        .hasMessageContaining("outside the field");
  }

  @Test
  void itWaitsAsLongAsItsParametersSay() {
    agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine"));
    RecruitmentAgentImpl uav = agent("uav", kept, Map.of("help_every", "0.5"));
    time.advance(Duration.ofSeconds(1));
    uav.callForHelp(call("mine"));
    time.advance(Duration.ofMillis(1700));
    assertThat(received).as("calls after 0, 0.5, 1 and 1.5 s").hasSize(4);
  }

  @Test
  void aStayMayBeLongerThanLeasesUsuallyAre() {
    Duration usual = LeaseTerms.DEFAULT.maxDuration();
    LeaseTerms terms = agent("ugv1", kept, Map.of()).leases().terms();
    assertThat(terms.maxDuration()).isEqualTo(Duration.ofMinutes(10)).isGreaterThan(usual);
    assertThat(terms.defaultDuration()).isEqualTo(LeaseTerms.DEFAULT.defaultDuration());
    LeaseTerms brief =
        agent("ugv2", StateStore.inMemory(), Map.of("max_stay", "2")).leases().terms();
    assertThat(brief.maxDuration()).isEqualTo(Duration.ofSeconds(2));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "help_every    | 0     | a number of seconds from 0.1 to 3600",
        "replace_after | soon  | a number of seconds from 0.1 to 3600",
        "replace_after | 1     | above margin, 1.0 s",
        "margin        | 20    | below replace_after, 20.0 s",
        "repeat_every  | -6    | a number of seconds from 0.1 to 3600",
        "agree_every   | 1e9   | a number of seconds from 0.1 to 3600",
        "help_rounds   | 0     | a number from 1 to 100",
        "accept_sends  | 2.5   | a whole number",
        "arrival_sends | many  | a number from 1 to 100",
        "release_every | 0.01  | a number of seconds from 0.1 to 3600",
        "max_stay  | 0.5   | a number of seconds from 1 to 86400",
        "offer_window   | 0     | a number of seconds from 0.1 to 10",
        "offer_window   | 11    | a number of seconds from 0.1 to 10",
        "shame_gain     | 0     | a number from 0.01 to 100",
        "shame_exponent | 11    | a number from 0.01 to 10",
        "shame_floor    | 0     | a number from 0.001 to 1",
        "shame_idle_factor     | 11    | a number from 0.01 to 10",
        "shame_busy_factor     | -1    | a number from 0.01 to 10",
        "eta_reference  | 0     | a number of seconds from 0.1 to 86400",
        "random_offer_probability  | 1.1   | a number from 0.01 to 1",
        "impatience_min_wait | 0  | a number of seconds from 0.1 to 3600",
        "impatience_max_wait | 1h | a number of seconds from 0.1 to 3600",
        "impatience_min_wait | 31 | at most impatience_max_wait, 30.0 s",
        "impatience_max_wait | 4  | at least impatience_min_wait, 5.0 s",
      })
  void aNumberThatCannotBeIsRefusedWithItsPlace(String name, String text, String wanted) {
    SourceLocation place = new SourceLocation("robot.xml", 12);
    Parameters written =
        new Parameters("ugv1/recruit", Map.of(name, new Parameters.Value(text, place)));
    ModuleContext context = new ModuleContext("ugv1", "recruit", written, time, kept);
    assertThatThrownBy(() -> new RecruitmentAgentImpl(context))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            place
                + ": ugv1/recruit: parameter "
                + name
                + " is \""
                + text
                + "\", which is not "
                + wanted);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "affective", "greedy"})
  void anUnknownAffectIsRefusedAtItsOwnPlace(String strategy) {
    Map<String, Parameters.Value> written = new HashMap<>();
    written.put("affect", new Parameters.Value("shamee", new SourceLocation("robot.xml", 12)));
    if (!strategy.isEmpty()) {
      written.put("strategy", new Parameters.Value(strategy, new SourceLocation("robot.xml", 11)));
    }
    ModuleContext context =
        new ModuleContext("ugv1", "recruit", new Parameters("ugv1/recruit", written), time, kept);
    assertThatThrownBy(() -> new RecruitmentAgentImpl(context))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "robot.xml:12: ugv1/recruit: parameter affect is \"shamee\", which is not shame or"
                + " impatience");
  }

  @Test
  void thoseThatDisagreeOnWhenAHelperIsLateSaySo() {
    RecruitmentAgentImpl uav = agent("uav", kept, Map.of());
    agent("ugv1", StateStore.inMemory(), Map.of("percepts", "mine"));
    RecruitmentAgentImpl other =
        agent("ugv2", StateStore.inMemory(), Map.of("replace_after", "40"));
    time.advance(Duration.ofSeconds(1));
    assertThat(disagreements(uav))
        .isEqualTo(
            "ugv2 has replace_after 40.0 s and margin 1.0 s, this agent 20.0 s and 1.0 s; set the"
                + " same values in the whole team, or a call may have two helpers");
    assertThat(disagreements(other)).contains("uav has replace_after 20.0 s", "; ugv1 has");
    listed.get(other).close();
    time.advance(Duration.ofSeconds(1));
    assertThat(disagreements(uav)).as("it has left").isEmpty();
  }

  private static String disagreements(RecruitmentAgentImpl agent) {
    return agent.parameters().stream()
        .filter(each -> each.name().equals("disagreements"))
        .findFirst()
        .orElseThrow()
        .value();
  }
}
