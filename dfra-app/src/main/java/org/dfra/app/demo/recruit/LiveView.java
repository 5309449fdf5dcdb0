package org.dfra.app.demo.recruit;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.app.demo.recruit.Conversations.Told;
import org.dfra.app.demo.recruit.Snapshot.Fate;
import org.dfra.app.demo.recruit.Snapshot.Robot;
import org.dfra.app.demo.stage.Narration;
import org.dfra.directory.ModuleDirectory;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.world.TruePose;
import org.jspecify.annotations.Nullable;

/**
 * Shows on a terminal what the team is at, twice a second, by a thread of its own, {@code
 * dfra-demo-live}. Where there is no terminal it does nothing: the narration tells enough.
 */
final class LiveView implements AutoCloseable {

  private static final long PERIOD_MILLIS = 500;

  /** Higher than this a robot flies, metres above the ground. */
  private static final double FLIES = 0.5;

  private final Narration tell;
  private final List<String> robots;
  private final Instant began;
  private final InstantSource clock;
  private final LocalFrame frame;
  private final Witness witness;
  private final Searches searches;
  private final Ways ways;
  private final @Nullable Batteries batteries; // null where there is no terminal
  private final @Nullable ScheduledExecutorService thread; // likewise
  private boolean isOver; // guarded by this

  /**
   * @param robots from the first line to the last
   * @param began the robots' time that the demonstration began at
   * @param clock the robots'
   * @param frame the world's
   */
  LiveView(
      Narration tell,
      List<String> robots,
      Instant began,
      InstantSource clock,
      LocalFrame frame,
      ModuleDirectory directory,
      Witness witness,
      Searches searches,
      Ways ways) {
    this.tell = tell;
    this.robots = List.copyOf(robots);
    this.began = began;
    this.clock = clock;
    this.frame = frame;
    this.witness = witness;
    this.searches = searches;
    this.ways = ways;
    this.batteries = tell.isTerminal() ? new Batteries(directory) : null;
    this.thread =
        tell.isTerminal()
            ? Executors.newSingleThreadScheduledExecutor(
                task -> {
                  Thread made = new Thread(task, "dfra-demo-live");
                  made.setDaemon(true);
                  return made;
                })
            : null;
  }

  /** Begins to draw. */
  void start() {
    if (thread != null) {
      var unused =
          thread.scheduleWithFixedDelay(this::draw, 0, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
    }
  }

  private synchronized void draw() {
    if (isOver) {
      return;
    }
    try {
      tell.redraw(SnapshotLines.of(now(), tell.columns() - 1));
    } catch (RuntimeException e) { // the demonstration goes on without it
      tell.redraw(List.of("", "What the team is at cannot be shown: " + e));
    }
  }

  private Snapshot now() {
    Instant time = clock.instant();
    List<Told> conversations = Conversations.of(witness.letters());
    List<Robot> all = new ArrayList<>();
    @Nullable CallState call = null;
    for (String name : robots) {
      RecruitmentStatus agent = witness.last(name).orElse(null);
      all.add(robot(name, agent, conversations, time));
      if (agent != null && agent.requester() != RequesterPhase.IDLE) {
        call = CallState.last(conversations, name).orElse(call);
      }
    }
    return new Snapshot(began, time, all, call);
  }

  private Robot robot(
      String name, @Nullable RecruitmentStatus agent, List<Told> conversations, Instant time) {
    TruePose pose = ways.at(name, time);
    Optional<CallState> served =
        agent == null || agent.helped() == null
            ? Optional.empty()
            : CallState.last(conversations, agent.helped())
                .filter(each -> name.equals(each.chosen()));
    @Nullable Double distance = null;
    @Nullable Double lease = null;
    if (agent != null && served.isPresent()) {
      if (agent.responder() == ResponderPhase.TRAVELLING) {
        distance = distance(pose, served.get().place());
      } else if (agent.responder().isCommitted() && served.get().stay() != null) {
        double left = Duration.between(time, served.get().stay()).toMillis() / 1000.0;
        lease = Math.max(0, left);
      }
    }
    return new Robot(
        name,
        fate(name),
        pose.up() > FLIES,
        agent,
        searches.last(name).orElse(null),
        distance,
        lease,
        batteries == null ? null : batteries.charge(name));
  }

  private double distance(TruePose pose, GeoPosition place) {
    LocalPosition there = frame.toLocal(place);
    return Math.hypot(there.east() - pose.east(), there.north() - pose.north());
  }

  private Fate fate(String name) {
    if (witness.isDead(name)) {
      return Fate.DEAD;
    } else if (witness.isCutOff(name)) {
      return Fate.CUT_OFF;
    }
    return witness.listening().contains(name) ? Fate.PRESENT : Fate.ABSENT;
  }

  /** {@inheritDoc} What was at last stays on the terminal. */
  @Override
  public synchronized void close() {
    if (thread == null || batteries == null || isOver) {
      return;
    }
    thread.shutdown();
    draw();
    isOver = true;
    tell.settle();
    batteries.close();
  }
}
