package org.dfra.autonomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.UnknownEventException;
import org.dfra.agent.AgentMessage;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpCallRejectedException;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.directory.Condition;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleQuery;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.RecruitmentMessage;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.RecruitmentMessage.Release;
import org.dfra.recruit.requester.Bid;
import org.dfra.recruit.river.AgentMessageEvent;
import org.dfra.recruit.river.RecruitmentAgentProxy;
import org.dfra.recruit.river.RemoteRecruitmentAgent;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/**
 * Two agents as the properties that come with DFRA describe them, found in a lookup service: one
 * asks, the other comes by its robot's own behaviours.
 */
@Timeout(240)
class RecruitmentAgentsTest {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir Path folder;

  private ServedRobots robots;

  @BeforeEach
  void begin() throws Exception {
    robots = new ServedRobots(folder, REGGIE, PATIENCE);
    robots.serveSmallRobot();
    robots.serve(
        "agent",
        "recruitment-agent",
        Map.of("percepts", "mine,heat", "tolerance", "0.6", "speed", "0.7"));
    robots.serve("uav", "agent", "recruitment-agent", Map.of());
  }

  @AfterEach
  void end() {
    robots.close();
  }

  /** The agent by the network, as anybody has it who is elsewhere. */
  private RecruitmentAgentProxy far(String query) throws Exception {
    RecruitmentAgentProxy near = (RecruitmentAgentProxy) robots.find(query).module();
    RecruitmentAgentProxy far =
        new RecruitmentAgentProxy(near.server(), UUID.randomUUID(), near.identification());
    assertThat(far.awaitReadiness(PATIENCE).serves()).isTrue();
    return far;
  }

  private static HelpCall call(String percept, double east, Duration stay) {
    return new HelpCall(percept, SmallRobot.at(east, 0), stay, Duration.ofMinutes(2));
  }

  /** As soon as the caller's own directory knows the other, and the other where it is. */
  private static void help(RecruitmentAgent asking, HelpCall call) {
    await()
        .atMost(PATIENCE)
        .ignoreExceptionsMatching(
            e ->
                e instanceof HelpCallRejectedException
                    && String.valueOf(e.getMessage()).contains("no robot within reach"))
        .until(
            () -> {
              asking.callForHelp(call);
              return true;
            });
  }

  @Test
  void oneAsksTheOtherComesStaysAndIsReleased() throws Exception {
    RecruitmentAgentProxy asking = far("RecruitmentAgent on uav");
    RecruitmentAgentProxy helping = far("RecruitmentAgent with recruitment.percepts contains mine");
    assertThat(helping.identification().robot()).isEqualTo("robot");
    List<RecruitmentStatus> asked = ServedRobots.received(asking, RecruitmentStatus.class);
    List<RecruitmentStatus> helped = ServedRobots.received(helping, RecruitmentStatus.class);

    help(asking, call("mine", 4, Duration.ofMinutes(5)));
    assertThatThrownBy(() -> asking.callForHelp(call("mine", 2, Duration.ofSeconds(5))))
        .isInstanceOf(HelpCallRejectedException.class)
        .hasMessageStartingWith("uav already calls for help");
    await()
        .atMost(PATIENCE)
        .until(() -> asking.status().requesterPhase() == RequesterPhase.BEING_HELPED);
    assertThat(asking.status().helperRobot()).isEqualTo("robot");
    assertThat(helping.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
    assertThat(helping.status().helpedRobot()).isEqualTo("uav");
    assertThat(SmallRobot.east()).isCloseTo(4, within(1.0));

    asking.release();
    await().atMost(PATIENCE).until(() -> helping.status().responderPhase() == ResponderPhase.FREE);
    await().atMost(PATIENCE).until(() -> asking.status().requesterPhase() == RequesterPhase.IDLE);
    assertThat(helping.status().helpedRobot()).isNull();
    await().atMost(PATIENCE).until(() -> last(helped).responderPhase() == ResponderPhase.FREE);
    await().atMost(PATIENCE).until(() -> last(asked).requesterPhase() == RequesterPhase.IDLE);
    assertThat(helped.stream().map(RecruitmentStatus::responderPhase).distinct())
        .containsSubsequence(
            ResponderPhase.OFFERED, ResponderPhase.TRAVELLING, ResponderPhase.LEASED);
    assertThat(asked.stream().map(RecruitmentStatus::requesterPhase).distinct())
        .containsSubsequence(
            RequesterPhase.CALLING, RequesterPhase.AWARDED, RequesterPhase.BEING_HELPED);
    assertThat(last(helped).urge()).as("it has atoned").isZero();
  }

  @Test
  void theLeaseEndsByItself() throws Exception {
    RecruitmentAgentProxy asking = far("RecruitmentAgent on uav");
    RecruitmentAgentProxy helping = far("RecruitmentAgent with recruitment.percepts contains heat");
    help(asking, call("heat", 0.2, Duration.ofSeconds(4)));
    await()
        .atMost(PATIENCE)
        .until(() -> helping.status().responderPhase() == ResponderPhase.LEASED);
    await().atMost(PATIENCE).until(() -> helping.status().responderPhase() == ResponderPhase.FREE);
    await().atMost(PATIENCE).until(() -> asking.status().requesterPhase() == RequesterPhase.IDLE);
  }

  @Test
  void whatCannotBeCrossesTheNetworkAsItself() throws Exception {
    RecruitmentAgentProxy asking = far("RecruitmentAgent on uav");
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThatThrownBy(() -> asking.callForHelp(call("gold", 1, Duration.ofSeconds(5))))
                    .isInstanceOf(HelpCallRejectedException.class)
                    .hasMessage(
                        "no robot within reach of uav can observe \"gold\"; other robots observe heat, mine")
                    .extracting(each -> ((HelpCallRejectedException) each).reason())
                    .isEqualTo(HelpCallRejectedException.Reason.NO_CAPABLE_ROBOT));
    Strange strange = new Strange("uav", 1);
    assertThatThrownBy(() -> asking.receive(strange))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("uav/agent accepts recruitment messages, not");
    asking.receive(
        new MessageEnvelope(
            "robot",
            1,
            Instant.now(),
            new Release(new Conversation("nobody", 1), "it is meant for somebody else", false)));
    assertThat(asking.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
  }

  /** A message of another kind of agents. */
  private record Strange(String sender, long number) implements AgentMessage {}

  @Test
  void anEventOfAnotherKindIsUnknown() throws Exception {
    RemoteRecruitmentAgent server =
        (RemoteRecruitmentAgent) far("RecruitmentAgent on uav").server();
    assertThatThrownBy(
            () -> server.notify(new RemoteEvent("robot", AgentMessageEvent.EVENT_ID, 1, null)))
        .isInstanceOf(UnknownEventException.class)
        .hasMessage("uav/agent accepts messages of agents, not " + RemoteEvent.class.getName());
  }

  @Test
  void messagesAreRemoteEventsWhoseNumbersGrow() throws Exception {
    RecruitmentAgentProxy asking = far("RecruitmentAgent on uav");
    BlockingQueue<RemoteEvent> come = new LinkedBlockingQueue<>();
    try (Eavesdropper other = Eavesdropper.observing("gas", REGGIE, come::add)) {
      help(asking, call("gas", 4, Duration.ofSeconds(5)));
      AgentMessageEvent first =
          (AgentMessageEvent) come.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS);
      assertThat(first).as("%s is notified of the call", other).isNotNull();
      assertThat(first.getSource()).isEqualTo("uav");
      assertThat(first.getID()).isEqualTo(AgentMessageEvent.EVENT_ID);
      assertThat(message(first)).isInstanceOf(Help.class);
      asking.release();
      AgentMessageEvent last = first;
      while (!(message(last) instanceof Release)) { // HELP may have been repeated
        AgentMessageEvent next =
            (AgentMessageEvent) come.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS);
        assertThat(next).as("after %s", message(last)).isNotNull();
        assertThat(next.getSequenceNumber()).isGreaterThan(last.getSequenceNumber());
        assertThat(next.getSequenceNumber()).isEqualTo(next.message().number());
        last = next;
      }
    }
  }

  private static RecruitmentMessage message(AgentMessageEvent event) {
    return ((MessageEnvelope) event.message()).message();
  }

  @Test
  void othersAreAnnouncedAsTheyAppear() throws Exception {
    List<String> come = new CopyOnWriteArrayList<>();
    ModuleQuery<RecruitmentAgent> heat =
        ModuleQuery.of(RecruitmentAgent.class)
            .where(RecruitmentAttributes.class, "percepts", Condition.contains("heat"));
    try (DirectoryRegistration watch =
        robots.directory().listen(heat, listing -> come.add(listing.robot()))) {
      await().atMost(PATIENCE).until(() -> come.contains("robot"));
      robots.serve("other", "agent", "recruitment-agent", Map.of("percepts", "heat"));
      await().atMost(PATIENCE).until(() -> come.contains("other"));
      assertThat(come).as("the UAV observes nothing; %s", watch).doesNotContain("uav");
    }
  }

  /** As a user writes one, and names it in the agent's properties. */
  public static final class Courteous implements RecruitmentStrategy {

    @Override
    public String name() {
      return "courteous";
    }

    @Override
    public boolean shouldOffer(Stimulus stimulus) {
      return true;
    }

    @Override
    public Bid choose(List<Bid> bids) {
      return RecruitmentStrategy.nearest(bids);
    }
  }

  @Test
  void aStrategyIsTakenByItsClassAndAnUnknownOneIsRefusedWhileOthersGoOn() throws Exception {
    String written = Courteous.class.getName().replace("$", "$$"); // one is of a variable
    robots.serve("third", "agent", "recruitment-agent", Map.of("strategy", written));
    RecruitmentAgentProxy third = far("RecruitmentAgent with recruitment.strategy = courteous");
    assertThat(third.identification().robot()).isEqualTo("third");
    assertThatThrownBy(
            () -> robots.serve("fourth", "agent", "recruitment-agent", Map.of("strategy", "gredy")))
        .hasMessageContaining("unknown strategy \"gredy\"; did you mean \"greedy\"?");
    RecruitmentAgentProxy asking = far("RecruitmentAgent on uav");
    help(asking, call("mine", 0.2, Duration.ofMinutes(5)));
    await()
        .atMost(PATIENCE)
        .until(() -> asking.status().requesterPhase() == RequesterPhase.BEING_HELPED);
    assertThat(asking.status().helperRobot()).isEqualTo("robot");
  }

  private static RecruitmentStatus last(List<RecruitmentStatus> all) {
    return all.get(all.size() - 1);
  }
}
