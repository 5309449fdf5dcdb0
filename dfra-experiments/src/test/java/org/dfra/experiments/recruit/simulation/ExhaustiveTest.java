package org.dfra.experiments.recruit.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.experiments.network.SimulatedNetwork;
import org.dfra.experiments.recruit.simulation.ExperimentField.FieldPoint;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.affect.Shame;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.agent.AgentSnapshot;
import org.dfra.recruit.agent.Recruiter;
import org.dfra.recruit.agent.RecruiterListener;
import org.dfra.recruit.agent.RecruiterPorts;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.requester.RequesterAction;
import org.dfra.recruit.responder.ResponderAction;
import org.dfra.recruit.strategy.StrategyRegistry;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.recruit.transport.VirtualTime;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A requester and two that may help, and everything that can happen to up to two of their messages:
 * lost, late by several spans (so overtaken by others), twice, or the last that its sender's
 * process sends at all. Every such run ends with all free, never has two helpers, and with help
 * wherever somebody is left to give it.
 *
 * <p>{@code -Ddfra.full=true} tries all kinds in pairs, otherwise pairs of losses and single ones
 * of the others.
 */
class ExhaustiveTest {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final double USUAL = 0.01; // seconds on the way
  private static final double[] SPANS = {0.5, 3, 8, 40}; // seconds

  private enum Kind {
    LOST,
    LATE,
    TWICE,
    LAST
  }

  private record Fault(int message, Kind kind, double span) {}

  private static final double NEVER = 300; // seconds: all is over by then

  private int runs;

  @ParameterizedTest
  @ValueSource(strings = {"affective", "greedy", "contract-net"})
  void allAreFreeInTheEndWhateverHappensToTwoMessages(String strategy) {
    explore(strategy, NEVER, List.of());
    assertThat(runs).as("%s", strategy).isGreaterThan(FULL ? 4_000 : 100);
    System.out.println(strategy + ": " + runs + " runs");
  }

  /** At times at which a helper is awaited, on its way, just there, and agreed with. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 3, 4.015, 8})
  void aHelperThatIsLetGoIsFreeSoon(double letGoAfter) {
    explore("greedy", letGoAfter, List.of());
    System.out.println("let go after " + letGoAfter + " s: " + runs + " runs");
  }

  private void explore(String strategy, double letGoAfter, List<Fault> faults) {
    int envelopes = new Play(strategy, letGoAfter, faults).play();
    runs++;
    if (faults.size() == 2) {
      return;
    }
    int next = faults.isEmpty() ? 0 : faults.get(0).message() + 1;
    for (int i = next; i < envelopes; i++) {
      for (Fault fault : faultsOf(i, faults)) {
        List<Fault> more = new ArrayList<>(faults);
        more.add(fault);
        explore(strategy, letGoAfter, more);
      }
    }
  }

  private static List<Fault> faultsOf(int envelope, List<Fault> before) {
    List<Fault> all = new ArrayList<>();
    all.add(new Fault(envelope, Kind.LOST, 0));
    boolean isSecond = !before.isEmpty();
    if (!FULL && isSecond) {
      return before.get(0).kind() == Kind.LOST ? all : List.of();
    }
    all.add(new Fault(envelope, Kind.LAST, 0));
    for (double span : SPANS) {
      all.add(new Fault(envelope, Kind.LATE, span));
      all.add(new Fault(envelope, Kind.TWICE, span));
    }
    return all;
  }

  /** One run. */
  private static final class Play {

    private final List<Fault> faults;
    private final VirtualTime time = new VirtualTime(Instant.parse("2026-11-21T00:00:00Z"));
    private final SimulatedNetwork network = new SimulatedNetwork(time, this::passage);
    private final InvariantChecker referee = new InvariantChecker(time);
    private final List<Recruiter> agents = new ArrayList<>();
    private final List<ExperimentRobot> bodies = new ArrayList<>();
    private final List<String> names = List.of("uav", "ugv1", "ugv2");
    private final List<String> dead = new ArrayList<>();
    private final double letGoAfter;
    private final String reported;
    private int envelopes;
    private boolean isComplete;

    Play(String strategy, double letGoAfter, List<Fault> faults) {
      this.faults = faults;
      this.letGoAfter = letGoAfter;
      this.reported = strategy + ", let go after " + letGoAfter + " s, " + faults;
      for (int i = 0; i < names.size(); i++) {
        add(strategy, i);
      }
    }

    private void add(String strategy, int number) {
      String name = names.get(number);
      Set<String> percepts = number == 0 ? Set.of() : Set.of("mine");
      ExperimentRobot body =
          new ExperimentRobot(
              time,
              percepts,
              1,
              new SplittableRandom(1),
              null,
              new FieldPoint(30 + 4 * number, 50));
      LeaseRegistry leases = new LeaseRegistry(name, LeaseTerms.DEFAULT, time, time, clients -> {});
      Recruiter agent =
          new Recruiter(
              name,
              RecruitmentSettings.DEFAULT,
              StrategyRegistry.named(
                  strategy,
                  new Shame(ShameSettings.forField(ExperimentField.DIAGONAL, 1)),
                  new SplittableRandom(2)),
              MessageMode.BROADCAST,
              new RecruiterPorts(network.transport(name), body, leases, time, time),
              new Watch(name),
              Optional.empty());
      network.join(name, percepts, agent::receive);
      bodies.add(body);
      agents.add(agent);
      agent.start();
    }

    private double[] passage(String to, MessageEnvelope envelope) {
      int number = envelopes++;
      if (dead.contains(envelope.sender())) {
        return new double[0];
      }
      for (Fault fault : faults) {
        if (fault.message() == number) {
          return suffer(fault, envelope.sender());
        }
      }
      return new double[] {USUAL};
    }

    private double[] suffer(Fault fault, String sender) {
      return switch (fault.kind()) {
        case LOST -> new double[0];
        case LATE -> new double[] {USUAL + fault.span()};
        case TWICE -> new double[] {USUAL, USUAL + fault.span()};
        case LAST -> {
          dead.add(sender);
          var unused = time.after(0, () -> die(sender));
          yield new double[] {USUAL};
        }
      };
    }

    private void die(String name) {
      int number = names.indexOf(name);
      network.leave(name);
      agents.get(number).close();
      bodies.get(number).die();
    }

    /** How many messages were sent. */
    int play() {
      agents
          .get(0)
          .help(
              new HelpCall(
                  "mine",
                  ExperimentField.toEarth(new FieldPoint(40, 50)),
                  Duration.ofSeconds(10),
                  Duration.ofSeconds(200)));
      time.advance(Duration.ofNanos((long) (letGoAfter * 1e9)));
      if (!dead.contains("uav")) {
        agents.get(0).release();
      }
      time.advance(Duration.ofSeconds(400));
      boolean isRequesterDead = dead.contains("uav");
      for (int i = 0; i < names.size(); i++) {
        if (!dead.contains(names.get(i))) {
          assertThat(agents.get(i).status().responderPhase())
              .as("%s: %s", reported, names.get(i))
              .isEqualTo(ResponderPhase.FREE);
        }
      }
      if (dead.isEmpty()) {
        assertThat(referee.doubles()).as("%s: second helpers", reported).isZero();
        assertThat(referee.orphans()).as("%s: orphans", reported).isZero();
      }
      if (!isRequesterDead) {
        assertThat(agents.get(0).status().requesterPhase())
            .as("%s", reported)
            .isEqualTo(RequesterPhase.IDLE);
        if (letGoAfter == NEVER && !dead.containsAll(List.of("ugv1", "ugv2"))) {
          assertThat(isComplete).as("%s: help came", reported).isTrue();
        }
      }
      return envelopes;
    }

    private final class Watch implements RecruiterListener {
      private final String name;

      Watch(String name) {
        this.name = name;
      }

      @Override
      public void snapshotChanged(AgentSnapshot snapshot) {
        referee.update(name, snapshot);
      }

      @Override
      public void performed(ResponderAction action) {
        if (action instanceof ResponderAction.TravelTo) {
          referee.committed("uav");
        }
      }

      @Override
      public void performed(RequesterAction action) {
        isComplete |= action instanceof RequesterAction.Complete;
      }
    }
  }
}
