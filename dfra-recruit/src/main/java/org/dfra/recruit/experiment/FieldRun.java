package org.dfra.recruit.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.random.RandomGenerator;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpRefusedException;
import org.dfra.agent.ResponderPhase;
import org.dfra.recruit.agent.AgentSnapshot;
import org.dfra.recruit.agent.RecruiterListener;
import org.dfra.recruit.message.RecruitmentMessage.ResponderId;
import org.dfra.recruit.requester.RequesterAction;
import org.dfra.recruit.responder.ResponderAction;

/**
 * One run: an aircraft that scans the whole field and calls for help at intervals, two vehicles
 * that scan half of it each, and others that stand. Runs of one seed have the same places to be
 * helped at; with as many vehicles also the same beginnings, so they are compared in pairs.
 */
final class FieldRun {

  private static final String PERCEPT = "mine";
  private static final String AIRCRAFT = "uav";
  private static final int SCANNERS = 2;
  private static final double SWATH = 5; // metres
  private static final double EDGE = 5; // metres: no call is nearer to the edge

  private final Cell cell;
  private final Plan plan;
  private final long seed;
  private final Venue venue;
  private final Referee referee;
  private final List<FieldRobot> vehicles = new ArrayList<>();
  private final List<Venue.Agent> helpers = new ArrayList<>();
  private final Venue.Agent aircraft;
  private final Diary diary = new Diary(); // guarded by itself

  /**
   * Has robots and agents take their places.
   *
   * @throws Exception what the venue throws
   */
  FieldRun(Cell cell, Plan plan, long seed, Venue venue) throws Exception {
    this.cell = cell;
    this.plan = plan;
    this.seed = seed;
    this.venue = venue;
    this.referee = new Referee(venue.time());
    RandomGenerator places = stream(3);
    RasterRoute whole = new RasterRoute(0, 0, Field.SIDE, Field.SIDE, SWATH);
    FieldRobot uav = new FieldRobot(venue.time(), Set.of(), 5, places, whole, start(whole, places));
    this.aircraft = agent(AIRCRAFT, uav, 4, new Caller());
    for (int i = 0; i < cell.vehicles(); i++) {
      vehicles.add(vehicle(i, places));
      helpers.add(agent("ugv" + (i + 1), vehicles.get(i), 100 + i, new Committed()));
    }
  }

  /** A run over the simulated network. */
  static RunResult simulated(Cell cell, Plan plan, long seed) throws Exception {
    return new FieldRun(cell, plan, seed, new SimulatedVenue(cell, plan, seed)).run();
  }

  private RandomGenerator stream(int purpose) {
    return Seeds.stream(seed, purpose);
  }

  private static Point start(RasterRoute route, RandomGenerator lot) {
    return new Point(lot.nextDouble() * 2 * route.length(), 0);
  }

  private FieldRobot vehicle(int number, RandomGenerator places) {
    if (number >= SCANNERS) {
      return new FieldRobot(
          venue.time(),
          Set.of(PERCEPT),
          FieldRobot.SPEED,
          stream(200 + number),
          null,
          somewhere(places));
    }
    double half = Field.SIDE / SCANNERS;
    RasterRoute route = new RasterRoute(number * half, 0, half - SWATH, Field.SIDE, SWATH);
    return new FieldRobot(
        venue.time(),
        Set.of(PERCEPT),
        FieldRobot.SPEED,
        stream(200 + number),
        route,
        start(route, places));
  }

  private static Point somewhere(RandomGenerator lot) {
    double inner = Field.SIDE - 2 * EDGE;
    return new Point(EDGE + lot.nextDouble() * inner, EDGE + lot.nextDouble() * inner);
  }

  private Venue.Agent agent(String name, FieldRobot body, int purpose, Named listener)
      throws Exception {
    listener.name = name;
    return venue.join(
        new Venue.Member(
            name,
            body.canObserve(PERCEPT) ? Set.of(PERCEPT) : Set.of(),
            body,
            plan.strategy(cell.strategy(), stream(purpose)),
            cell.mode(),
            plan.settings(),
            listener));
  }

  private double now() {
    return venue.time().nanos() / 1e9;
  }

  /**
   * Runs it.
   *
   * @throws Exception what the venue throws
   */
  RunResult run() throws Exception {
    venue.open();
    RandomGenerator places = stream(5);
    for (int i = 0; i < plan.calls(); i++) {
      Point place = somewhere(places);
      aircraft.release(); // what is still under way has failed
      synchronized (diary) {
        diary.call(now(), place);
      }
      call(place);
      venue.advance(plan.period());
    }
    aircraft.release();
    double lost = vehicles.stream().mapToDouble(FieldRobot::rasterTimeLost).sum();
    venue.advance(plan.rest());
    referee.end();
    synchronized (diary) {
      return result(lost);
    }
  }

  private void call(Point place) {
    try {
      aircraft.help(new HelpCall(PERCEPT, Field.toEarth(place), plan.stay(), plan.patience()));
    } catch (HelpRefusedException e) {
      // Over a real network it may see nobody just now. That is a call without help, and counts.
    }
  }

  private RunResult result(double lost) {
    return new RunResult(
        seed,
        plan.calls(),
        diary.completed,
        diary.successes,
        venue.transmissions(),
        venue.receptions(),
        diary.allocation.mean(),
        diary.arrival.mean(),
        diary.regret.mean(),
        referee.doubles(),
        referee.orphans(),
        lost,
        vehicles.stream().mapToDouble(FieldRobot::travelled).average().orElse(0));
  }

  /** Shows its states to the referee. */
  private class Named implements RecruiterListener {
    String name = "";

    @Override
    public void keep(AgentSnapshot snapshot) {
      referee.sees(name, snapshot);
    }
  }

  /** A vehicle's. */
  private final class Committed extends Named {
    @Override
    public void did(ResponderAction action) {
      if (action instanceof ResponderAction.Go) {
        referee.committed(AIRCRAFT);
      }
    }
  }

  /** The aircraft's. */
  private final class Caller extends Named {
    @Override
    public void did(RequesterAction action) {
      synchronized (diary) {
        note(action);
      }
    }

    private void note(RequesterAction action) {
      if (action instanceof RequesterAction.Complete) {
        diary.complete(now() <= diary.called + plan.deadline().toNanos() / 1e9);
      } else if (action instanceof RequesterAction.Hold) {
        diary.arrive(now());
      } else if (action instanceof RequesterAction.ToTeam team
          && team.message() instanceof ResponderId id) {
        awarded(id.winner());
      } else if (action instanceof RequesterAction.ToOne one
          && one.message() instanceof ResponderId id
          && one.robot().equals(id.winner())) {
        awarded(id.winner());
      }
    }

    private void awarded(String winner) {
      if (diary.isAwarded) {
        return;
      }
      double best = Double.POSITIVE_INFINITY;
      double chosen = 0;
      for (int i = 0; i < vehicles.size(); i++) {
        double eta = vehicles.get(i).seconds(diary.place);
        ResponderPhase phase = helpers.get(i).status().responder();
        best = phase.isCommitted() ? best : Math.min(best, eta);
        chosen = winner.equals("ugv" + (i + 1)) ? eta : chosen;
      }
      diary.award(now(), Math.max(0, chosen - best));
    }
  }
}
