package org.dfra.experiments.recruit.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.agent.Recruiter;
import org.dfra.recruit.agent.RecruiterListener;
import org.dfra.recruit.agent.RecruiterPorts;
import org.dfra.recruit.agent.RobotPort;
import org.dfra.recruit.requester.RequesterAction;
import org.dfra.recruit.responder.ResponderState;
import org.dfra.recruit.strategy.Greedy;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.recruit.transport.VirtualTime;
import org.dfra.time.Scheduler;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * An agent whose process is suspended and resumed, as by {@code SIGSTOP} and {@code SIGCONT}, all
 * through a recruitment ({@code -Ddfra.full=true}: every half second) and for every span. Its clock
 * continues; it handles no message and no timer meanwhile, and all of them at once afterwards, in
 * either order. What drives its robot is another process and continues.
 *
 * <p>There must never be two robots of which each has a valid lease of the task or moves for it.
 */
class SuspendedAgentTest {

  private static final Duration STEP = Duration.ofMillis(100);
  private static final double[] SPANS = {2, 7, 15, 30, 80}; // seconds
  private static final double EACH = Boolean.getBoolean("dfra.full") ? 0.5 : 1.5; // seconds
  private static final double LAST = 45; // seconds: the recruitment is over by then, or another

  @ParameterizedTest(name = "{0}, messages first: {1}")
  @CsvSource({"near, true", "near, false", "far, true", "far, false", "uav, true", "uav, false"})
  void thereAreNeverTwoHelpersWhicheverRobotIsSuspended(String robot, boolean messagesFirst) {
    suspendAtAnyTime(robot, messagesFirst, 1);
  }

  /** The nearer robot needs four times as long as it expects: it is replaced on its way. */
  @ParameterizedTest(name = "{0}, messages first: {1}")
  @CsvSource({"near, true", "near, false", "far, true", "far, false", "uav, true", "uav, false"})
  void norWhereTheOneThatIsLateIsSuspended(String robot, boolean messagesFirst) {
    suspendAtAnyTime(robot, messagesFirst, 4);
  }

  private static void suspendAtAnyTime(String robot, boolean messagesFirst, double optimism) {
    for (double span : SPANS) {
      for (double from = 0.5; from < LAST; from += EACH) {
        new Play(robot, from, span, messagesFirst, optimism).play();
      }
    }
  }

  /** One recruitment. */
  private static final class Play {

    private final VirtualTime time = new VirtualTime(Instant.parse("2026-11-21T00:00:00Z"));
    private final SimulatedNetwork network =
        new SimulatedNetwork(time, (to, envelope) -> new double[] {0.01});
    private final Map<String, Recruiter> agents = new HashMap<>();
    private final Map<String, ExperimentRobot> bodies = new HashMap<>();
    private final Map<String, FieldPoint> places = new HashMap<>();
    private final String scenario;
    private final boolean messagesFirst;
    private final double optimism; // of the nearer robot: its true time of travel by its ETA
    private final List<Runnable> envelopes = new ArrayList<>(); // that came meanwhile
    private final List<Runnable> timers = new ArrayList<>(); // that were due meanwhile
    private boolean isSuspended;
    private boolean isComplete;

    Play(String robot, double from, double span, boolean messagesFirst, double optimism) {
      this.optimism = optimism;
      this.scenario = robot + " suspended at " + from + " s for " + span + " s";
      this.messagesFirst = messagesFirst;
      add("uav", Set.of(), 0, robot);
      add("near", Set.of("mine"), 30, robot);
      add("far", Set.of("mine"), 10, robot);
      Scheduler.ScheduledTask unused = time.after(Math.round(from * 1e9), () -> isSuspended = true);
      Scheduler.ScheduledTask alsoUnused =
          time.after(Math.round((from + span) * 1e9), this::resume);
    }

    private void add(String name, Set<String> percepts, double east, String suspended) {
      ExperimentRobot body =
          new ExperimentRobot(
              time, percepts, 1, new SplittableRandom(1), null, new FieldPoint(east, 50));
      bodies.put(name, body);
      places.put(name, body.position());
      boolean isIt = name.equals(suspended);
      Recruiter agent =
          new Recruiter(
              name,
              RecruitmentSettings.DEFAULT,
              new Greedy(),
              MessageMode.BROADCAST,
              new RecruiterPorts(
                  network.transport(name),
                  new RemoteBody(body, name.equals("near") ? optimism : 1, isIt),
                  new LeaseRegistry(name, LeaseTerms.DEFAULT, time, time, clients -> {}),
                  time,
                  isIt ? new Timer() : time),
              new RecruiterListener() {
                @Override
                public void performed(RequesterAction action) {
                  isComplete |= action instanceof RequesterAction.Complete;
                }
              },
              Optional.empty());
      agents.put(name, agent);
      network.join(
          name,
          percepts,
          envelope -> {
            if (isIt) {
              handle(envelopes, () -> agent.receive(envelope));
            } else {
              agent.receive(envelope);
            }
          });
      agent.start();
    }

    private void handle(List<Runnable> waiting, Runnable event) {
      if (isSuspended) {
        waiting.add(event);
      } else {
        event.run();
      }
    }

    private void resume() {
      isSuspended = false;
      List<Runnable> all = new ArrayList<>(messagesFirst ? envelopes : timers);
      all.addAll(messagesFirst ? timers : envelopes);
      all.forEach(Runnable::run);
    }

    void play() {
      agents
          .get("uav")
          .help(
              new HelpCall(
                  "mine",
                  ExperimentField.toEarth(new FieldPoint(90, 50)),
                  Duration.ofSeconds(10),
                  Duration.ofSeconds(400)));
      for (Duration now = STEP; now.compareTo(Duration.ofSeconds(700)) < 0; now = now.plus(STEP)) {
        time.advance(STEP);
        boolean isNearHelping = helps("near");
        boolean isFarHelping = helps("far");
        if (isNearHelping && isFarHelping) { // asked millions of times
          throw new AssertionError(scenario + ": both help after " + now);
        }
      }
      for (String robot : List.of("near", "far")) {
        assertThat(agents.get(robot).status().responderPhase())
            .as("%s: %s in the end", scenario, robot)
            .isEqualTo(ResponderPhase.FREE);
      }
      assertThat(agents.get("uav").status().requesterPhase())
          .as(scenario)
          .isEqualTo(RequesterPhase.IDLE);
      assertThat(isComplete).as("%s: help came", scenario).isTrue();
    }

    /** Whether its lease of the task is valid by its own clock, or it has moved. */
    private boolean helps(String robot) {
      FieldPoint before = places.get(robot);
      FieldPoint now = bodies.get(robot).position();
      places.put(robot, now);
      ResponderState state = agents.get(robot).snapshot().responder();
      boolean isBound = state.phase().isCommitted() && time.instant().isBefore(state.until());
      return isBound || now.distance(before) > 0.001;
    }

    /** The timer of the process that is suspended. */
    private final class Timer implements Scheduler {
      @Override
      public long nanos() {
        return time.nanos();
      }

      @Override
      public ScheduledTask after(long nanos, Runnable task) {
        return time.after(nanos, () -> handle(timers, task));
      }

      @Override
      public boolean isLockStep() {
        return true;
      }
    }

    /**
     * The body as its agent sees it: it drives in another process, which cannot reach the agent.
     */
    private final class RemoteBody implements RobotPort {
      private final ExperimentRobot body;
      private final double optimism;
      private final boolean isIt;

      RemoteBody(ExperimentRobot body, double optimism, boolean isIt) {
        this.body = body;
        this.optimism = optimism;
        this.isIt = isIt;
      }

      private void report(Runnable event) {
        if (isIt) {
          handle(timers, event);
        } else {
          event.run();
        }
      }

      @Override
      public boolean canObserve(String percept) {
        return body.canObserve(percept);
      }

      @Override
      public boolean isAvailable() {
        return body.isAvailable();
      }

      @Override
      public boolean hasOwnWork() {
        return body.hasOwnWork();
      }

      @Override
      public boolean isInField(GeoPosition place) {
        return body.isInField(place);
      }

      @Override
      public Optional<Duration> eta(GeoPosition place) {
        return body.eta(place).map(eta -> Duration.ofNanos((long) (eta.toNanos() / optimism)));
      }

      @Override
      public double battery() {
        return body.battery();
      }

      @Override
      public void travelTo(HelpCall call, long leaseEnd, TravelListener journey) {
        body.travelTo(
            call,
            leaseEnd,
            new TravelListener() {
              @Override
              public void arrived() {
                report(journey::arrived);
              }

              @Override
              public void failed(String why) {
                report(() -> journey.failed(why));
              }
            });
      }

      @Override
      public void extendLease(long leaseEnd) {
        body.extendLease(leaseEnd);
      }

      @Override
      public void observe(HelpCall call) {
        body.observe(call);
      }

      @Override
      public void resumeOwnWork() {
        body.resumeOwnWork();
      }
    }
  }
}
