package org.dfra.experiments.recruit.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.random.RandomGenerator;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpCallRejectedException;
import org.dfra.agent.ResponderPhase;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentField.FieldPoint;
import org.dfra.experiments.recruit.simulation.ExperimentField.RasterRoute;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.recruit.agent.AgentSnapshot;
import org.dfra.recruit.agent.RecruiterListener;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.requester.RequesterAction;
import org.dfra.recruit.responder.ResponderAction;

/**
 * One run: an aircraft that scans the whole field and calls for help at intervals, two vehicles
 * that scan half of it each, and others that are stationary. Runs of one seed have the same call
 * positions; with equal numbers of vehicles also the same initial positions, so they are compared
 * in pairs.
 */
final class FieldRun {

  private static final String PERCEPT = "mine";
  private static final String AIRCRAFT = "uav";
  private static final int SCANNERS = 2;
  private static final double SWATH = 5; // metres
  private static final double EDGE = 5; // metres: no call is nearer to the edge

  private final ExperimentCell cell;
  private final ExperimentPlan plan;
  private final long seed;
  private final ExperimentEnvironment environment;
  private final InvariantChecker referee;
  private final List<ExperimentRobot> vehicles = new ArrayList<>();
  private final List<ExperimentEnvironment.AgentHandle> helpers = new ArrayList<>();
  private final ExperimentEnvironment.AgentHandle aircraft;
  private final CallStatistics statistics = new CallStatistics(); // guarded by itself

  /**
   * Creates robots and agents.
   *
   * @throws Exception what the environment throws
   */
  FieldRun(ExperimentCell cell, ExperimentPlan plan, long seed, ExperimentEnvironment environment)
      throws Exception {
    this.cell = cell;
    this.plan = plan;
    this.seed = seed;
    this.environment = environment;
    this.referee = new InvariantChecker(environment.time());
    RandomGenerator places = stream(3);
    RasterRoute whole = new RasterRoute(0, 0, ExperimentField.SIDE, ExperimentField.SIDE, SWATH);
    ExperimentRobot uav =
        new ExperimentRobot(environment.time(), Set.of(), 5, places, whole, start(whole, places));
    this.aircraft = agent(AIRCRAFT, uav, 4, new RequesterObserver());
    for (int i = 0; i < cell.vehicles(); i++) {
      vehicles.add(vehicle(i, places));
      helpers.add(agent("ugv" + (i + 1), vehicles.get(i), 100 + i, new ResponderObserver()));
    }
  }

  /** A run with the simulated network. */
  static RunResult simulated(ExperimentCell cell, ExperimentPlan plan, long seed) throws Exception {
    return new FieldRun(cell, plan, seed, new VirtualTimeEnvironment(cell, plan, seed)).run();
  }

  private RandomGenerator stream(int purpose) {
    return Seeds.random(seed, purpose);
  }

  private static FieldPoint start(RasterRoute route, RandomGenerator random) {
    return new FieldPoint(random.nextDouble() * 2 * route.length(), 0);
  }

  private ExperimentRobot vehicle(int number, RandomGenerator places) {
    if (number >= SCANNERS) {
      return new ExperimentRobot(
          environment.time(),
          Set.of(PERCEPT),
          ExperimentRobot.SPEED,
          stream(200 + number),
          null,
          somewhere(places));
    }
    double half = ExperimentField.SIDE / SCANNERS;
    RasterRoute route =
        new RasterRoute(number * half, 0, half - SWATH, ExperimentField.SIDE, SWATH);
    return new ExperimentRobot(
        environment.time(),
        Set.of(PERCEPT),
        ExperimentRobot.SPEED,
        stream(200 + number),
        route,
        start(route, places));
  }

  private static FieldPoint somewhere(RandomGenerator random) {
    double inner = ExperimentField.SIDE - 2 * EDGE;
    return new FieldPoint(EDGE + random.nextDouble() * inner, EDGE + random.nextDouble() * inner);
  }

  private ExperimentEnvironment.AgentHandle agent(
      String name, ExperimentRobot body, int purpose, SnapshotObserver listener) throws Exception {
    listener.name = name;
    return environment.addAgent(
        new ExperimentEnvironment.AgentSpec(
            name,
            body.canObserve(PERCEPT) ? Set.of(PERCEPT) : Set.of(),
            body,
            plan.strategy(cell.strategy(), stream(purpose)),
            cell.mode(),
            plan.settings(),
            listener));
  }

  private double now() {
    return environment.time().nanos() / 1e9;
  }

  /**
   * Runs it.
   *
   * @throws Exception what the environment throws
   */
  RunResult run() throws Exception {
    environment.awaitConnected();
    RandomGenerator places = stream(5);
    for (int i = 0; i < plan.calls(); i++) {
      FieldPoint place = somewhere(places);
      aircraft.release(); // a call still pending has failed
      synchronized (statistics) {
        statistics.call(now(), place);
      }
      call(place);
      environment.advance(plan.period());
    }
    aircraft.release();
    double lost = vehicles.stream().mapToDouble(ExperimentRobot::rasterTimeLost).sum();
    environment.advance(plan.settlingTime());
    referee.end();
    synchronized (statistics) {
      return result(lost);
    }
  }

  private void call(FieldPoint place) {
    try {
      aircraft.callForHelp(
          new HelpCall(PERCEPT, ExperimentField.toEarth(place), plan.stay(), plan.patience()));
    } catch (HelpCallRejectedException e) {
      // On a real network it may see no other robot now. That counts as a call without help.
    }
  }

  private RunResult result(double lost) {
    return new RunResult(
        seed,
        plan.calls(),
        statistics.completed,
        statistics.successes,
        environment.transmissions(),
        environment.receptions(),
        statistics.allocation.mean(),
        statistics.arrival.mean(),
        statistics.regret.mean(),
        referee.doubles(),
        referee.orphans(),
        lost,
        vehicles.stream().mapToDouble(ExperimentRobot::travelled).average().orElse(0));
  }

  /** Passes its states to the invariant checker. */
  private class SnapshotObserver implements RecruiterListener {
    String name = "";

    @Override
    public void snapshotChanged(AgentSnapshot snapshot) {
      referee.update(name, snapshot);
    }
  }

  /** The agent of a vehicle. */
  private final class ResponderObserver extends SnapshotObserver {
    @Override
    public void performed(ResponderAction action) {
      if (action instanceof ResponderAction.TravelTo) {
        referee.committed(AIRCRAFT);
      }
    }
  }

  /** The agent of the aircraft. */
  private final class RequesterObserver extends SnapshotObserver {
    @Override
    public void performed(RequesterAction action) {
      synchronized (statistics) {
        note(action);
      }
    }

    private void note(RequesterAction action) {
      if (action instanceof RequesterAction.Complete) {
        statistics.complete(now() <= statistics.called + plan.deadline().toNanos() / 1e9);
      } else if (action instanceof RequesterAction.AcceptLease) {
        statistics.arrive(now());
      } else if (action instanceof RequesterAction.SendToTeam team
          && team.message() instanceof ResponderId id) {
        awarded(id.winner());
      } else if (action instanceof RequesterAction.SendToRobot one
          && one.message() instanceof ResponderId id
          && one.robot().equals(id.winner())) {
        awarded(id.winner());
      }
    }

    private void awarded(String winner) {
      if (statistics.isAwarded) {
        return;
      }
      double best = Double.POSITIVE_INFINITY;
      double chosen = 0;
      for (int i = 0; i < vehicles.size(); i++) {
        double eta = vehicles.get(i).seconds(statistics.place);
        ResponderPhase phase = helpers.get(i).status().responderPhase();
        best = phase.isCommitted() ? best : Math.min(best, eta);
        chosen = winner.equals("ugv" + (i + 1)) ? eta : chosen;
      }
      statistics.award(now(), Math.max(0, chosen - best));
    }
  }
}
