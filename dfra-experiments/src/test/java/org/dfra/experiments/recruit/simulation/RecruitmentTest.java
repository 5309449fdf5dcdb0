package org.dfra.experiments.recruit.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpCallRejectedException;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.experiments.network.SimulatedNetwork;
import org.dfra.experiments.recruit.simulation.ExperimentField.FieldPoint;
import org.dfra.lease.ModuleLease;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.agent.AgentSnapshot;
import org.dfra.recruit.agent.Recruiter;
import org.dfra.recruit.agent.RecruiterListener;
import org.dfra.recruit.agent.RecruiterPorts;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.RecruitmentMessage.Accept;
import org.dfra.recruit.message.RecruitmentMessage.Refuse;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.requester.Bid;
import org.dfra.recruit.strategy.Greedy;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.recruit.transport.VirtualTime;
import org.junit.jupiter.api.Test;

/** Recruitments, one at a time: what is promised where processes die and connections are cut. */
class RecruitmentTest {

  private static final Duration STAY = Duration.ofSeconds(20);

  private final VirtualTime time = new VirtualTime(Instant.parse("2026-11-21T00:00:00Z"));
  private final Set<String> cutOff = new HashSet<>();
  private final SimulatedNetwork network =
      new SimulatedNetwork(
          time,
          (to, envelope) ->
              cutOff.contains(to) || cutOff.contains(envelope.sender())
                  ? new double[0]
                  : new double[] {0.01});
  private final Map<String, LeaseRegistry> books = new HashMap<>();
  private final Map<String, ExperimentRobot> bodies = new HashMap<>();
  private final List<MessageEnvelope> toTeamOfOne = new ArrayList<>();
  private final Recruiter uav = agent("uav", Set.of(), new FieldPoint(0, 0), Optional.empty());
  private final Recruiter near = helper("near", 30);
  private final Recruiter far = helper("far", 45);

  private Recruiter helper(String name, double east) {
    return agent(name, Set.of("mine"), new FieldPoint(east, 50), Optional.empty());
  }

  private Recruiter agent(
      String name, Set<String> percepts, FieldPoint begin, Optional<AgentSnapshot> kept) {
    return agent(name, percepts, begin, kept, new Greedy());
  }

  private Recruiter agent(
      String name,
      Set<String> percepts,
      FieldPoint begin,
      Optional<AgentSnapshot> kept,
      RecruitmentStrategy strategy) {
    ExperimentRobot body =
        bodies.computeIfAbsent(
            name,
            unused -> new ExperimentRobot(time, percepts, 1, new SplittableRandom(1), null, begin));
    LeaseRegistry book = new LeaseRegistry(name, LeaseTerms.DEFAULT, time, time, clients -> {});
    books.put(name, book);
    Recruiter agent =
        new Recruiter(
            name,
            RecruitmentSettings.DEFAULT,
            strategy,
            MessageMode.BROADCAST,
            new RecruiterPorts(network.transport(name), body, book, time, time),
            new RecruiterListener() {
              @Override
              public void sent(String to, MessageEnvelope envelope) {
                if (!to.isEmpty()) {
                  toTeamOfOne.add(envelope);
                }
              }
            },
            kept);
    network.join(name, percepts, agent::receive);
    agent.start();
    return agent;
  }

  private static HelpCall call(double east) {
    return new HelpCall(
        "mine", ExperimentField.toEarth(new FieldPoint(east, 50)), STAY, Duration.ofSeconds(120));
  }

  private void seconds(double span) {
    time.advance(Duration.ofNanos((long) (span * 1e9)));
  }

  @Test
  void theNearestComesHoldsALeaseAndIsFreeWhenThatEnds() {
    uav.help(call(20));
    seconds(1);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.OFFERED);
    seconds(3);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.TRAVELLING);
    assertThat(far.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
    assertThat(uav.status().helperRobot()).isEqualTo("near");
    seconds(12);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
    assertThat(books.get("near").clients()).as("who is helped is a client").isEqualTo(1);
    ModuleLease lease = uav.lease().orElseThrow();
    assertThat(lease.isLive()).isTrue();
    assertThat(lease.expiration()).isAfter(time.instant());
    seconds(20);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
    assertThat(lease.isLive()).isFalse();
    assertThat(books.get("near").clients()).isZero();
  }

  @Test
  void closingTheLeaseSendsTheHelperHome() {
    uav.help(call(20));
    seconds(16);
    uav.lease().orElseThrow().close();
    seconds(0.1);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
  }

  @Test
  void anAdministratorWhoRevokesTheLeaseFreesTheHelper() {
    uav.help(call(20));
    seconds(16);
    LeaseRegistry book = books.get("near");
    assertThat(book.revoke(book.leases().get(0).handle())).isTrue();
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
  }

  @Test
  void aHelperThatDiesOnItsWayIsReplaced() {
    uav.help(call(20));
    seconds(4);
    near.close();
    network.leave("near");
    bodies.get("near").die();
    seconds(10 + 20 + 3);
    assertThat(uav.status().helperRobot()).isEqualTo("far");
    seconds(26);
    assertThat(far.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
  }

  @Test
  void aRequesterThatDiesFreesItsHelper() {
    uav.help(call(20));
    seconds(4);
    uav.close();
    network.leave("uav");
    seconds(40);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
  }

  @Test
  void aRequesterCutOffForLongerThanTheLeaseLosesItsHelper() {
    uav.help(call(20));
    seconds(16);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
    cutOff.add("uav");
    seconds(20);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
  }

  @Test
  void agentsGoOnWithWhatTheyWereAtWhenTheirProcessesDied() {
    uav.help(call(20));
    seconds(4);
    AgentSnapshot helping = near.snapshot();
    near.close();
    AgentSnapshot calling = uav.snapshot();
    uav.close();
    seconds(1);
    Recruiter helper = agent("near", Set.of("mine"), new FieldPoint(0, 0), Optional.of(helping));
    Recruiter caller = agent("uav", Set.of(), new FieldPoint(0, 0), Optional.of(calling));
    seconds(12);
    assertThat(helper.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
    assertThat(caller.status().requesterPhase()).isEqualTo(RequesterPhase.BEING_HELPED);
    AgentSnapshot leased = helper.snapshot();
    helper.close();
    seconds(1);
    Recruiter again = agent("near", Set.of("mine"), new FieldPoint(0, 0), Optional.of(leased));
    assertThat(books.get("near").clients()).as("the lease is granted again").isEqualTo(1);
    seconds(20);
    assertThat(again.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
  }

  @Test
  void whatItPromisedOutlivesTheOrderlyEndOfItsModule() {
    uav.help(call(20));
    seconds(16);
    books.get("near").close(); // a module's leases end before the module does
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
    AgentSnapshot leased = near.snapshot();
    near.close();
    seconds(1);
    Recruiter again = agent("near", Set.of("mine"), new FieldPoint(0, 0), Optional.of(leased));
    seconds(1);
    assertThat(again.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.BEING_HELPED);
    seconds(20);
    assertThat(again.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
  }

  /** It was busy in one round, and its message took until it had offered in another. */
  @Test
  void thatAHelperCouldNotComeInAnEarlierRoundDoesNotCountAnyMore() {
    uav.help(call(20));
    seconds(4);
    assertThat(uav.status().helperRobot()).isEqualTo("near");
    Conversation in = toTeamOfOne.get(0).message().conversation();
    uav.receive(
        new MessageEnvelope(
            "near", 90, time.instant(), new Refuse(in, "it helps another robot", false)));
    assertThat(uav.status().helperRobot()).isEqualTo("near");
    uav.receive(
        new MessageEnvelope("near", 91, time.instant(), new Refuse(in, "it is stuck", true)));
    assertThat(uav.status().helperRobot()).isNull();
  }

  @Test
  void itIsFreedByTimeThoughItsStrategyFails() {
    near.close();
    network.leave("near");
    Recruiter failing =
        agent(
            "near",
            Set.of("mine"),
            new FieldPoint(30, 50),
            Optional.empty(),
            new RecruitmentStrategy() {
              @Override
              public String name() {
                return "failing";
              }

              @Override
              public boolean shouldOffer(Stimulus stimulus) {
                return true;
              }

              @Override
              public Bid choose(List<Bid> bids) {
                throw new IllegalStateException("it cannot choose");
              }
            });
    uav.help(call(20));
    seconds(4);
    assertThat(failing.status().responderPhase()).isEqualTo(ResponderPhase.TRAVELLING);
    failing.help(call(60));
    uav.close();
    network.leave("uav");
    int failures = 0;
    for (int i = 0; i < 80; i++) {
      try {
        seconds(0.5);
      } catch (IllegalStateException e) {
        assertThat(e).hasMessage("it cannot choose");
        failures++;
      }
    }
    assertThat(failures).as("tried once a second at the most").isBetween(2, 41);
    assertThat(failing.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
  }

  @Test
  void aPatienceThatIsShorterThanAnIntervalOfCallsIsKept() {
    cutOff.add("uav");
    uav.help(new HelpCall("mine", call(20).position(), STAY, Duration.ofSeconds(3)));
    seconds(2.9);
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.CALLING);
    seconds(0.2);
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.IDLE);
  }

  @Test
  void anOfferAfterTheChoiceIsAnsweredToItsSenderAlone() {
    uav.help(call(20));
    seconds(4);
    MessageEnvelope late =
        toTeamOfOne.stream()
            .filter(
                envelope -> envelope.message() instanceof Accept && envelope.sender().equals("far"))
            .findFirst()
            .orElseThrow();
    toTeamOfOne.clear();
    uav.receive(late);
    assertThat(toTeamOfOne)
        .singleElement()
        .extracting(MessageEnvelope::message)
        .isInstanceOfSatisfying(ResponderId.class, id -> assertThat(id.winner()).isEqualTo("near"));
  }

  @Test
  void callsThatCannotBeAnsweredAreRefusedInASentence() {
    assertThatThrownBy(
            () -> uav.help(new HelpCall("gold", call(20).position(), STAY, Duration.ofSeconds(9))))
        .isInstanceOf(HelpCallRejectedException.class)
        .hasMessage("no robot within reach of uav can observe \"gold\"; other robots observe mine");
    assertThatThrownBy(() -> uav.help(call(120)))
        .isInstanceOf(HelpCallRejectedException.class)
        .hasMessageContaining("that is outside the field; choose a place inside it");
    uav.help(call(20));
    assertThatThrownBy(() -> uav.help(call(20)))
        .isInstanceOf(HelpCallRejectedException.class)
        .hasMessageContaining("uav already calls for help");
    seconds(16);
    assertThat(uav.status().requesterPhase())
        .as("it goes on")
        .isEqualTo(RequesterPhase.BEING_HELPED);
  }

  /** It has not received its release, and has a lease of the task yet. */
  @Test
  void nobodyElseIsAskedWhileAHelperThatWasLetGoMayNotKnowIt() {
    uav.help(call(20));
    seconds(16);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
    cutOff.add("near");
    uav.release();
    uav.help(call(50));
    seconds(10);
    assertThat(near.status().responderPhase()).isEqualTo(ResponderPhase.LEASED);
    assertThat(far.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
    assertThat(uav.status().lastChange()).contains("until the previous helper confirms");
    seconds(12);
    assertThat(near.status().responderPhase())
        .as("its lease is over")
        .isEqualTo(ResponderPhase.FREE);
    assertThat(far.status().responderPhase()).isEqualTo(ResponderPhase.TRAVELLING);
  }

  @Test
  void asSoonAsItConfirmsItsReleaseOthersAreAsked() {
    uav.help(call(20));
    seconds(16);
    cutOff.add("near");
    uav.release();
    uav.help(call(50));
    seconds(3);
    cutOff.clear();
    seconds(1);
    assertThat(near.status().responderPhase()).isNotEqualTo(ResponderPhase.LEASED);
    seconds(3);
    assertThat(uav.status().requesterPhase()).isEqualTo(RequesterPhase.AWARDED);
  }
}
