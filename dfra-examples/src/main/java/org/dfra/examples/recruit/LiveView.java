package org.dfra.examples.recruit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
import org.dfra.directory.ModuleDirectory;
import org.dfra.examples.recruit.Conversations.Attempt;
import org.dfra.examples.recruit.Snapshot.Availability;
import org.dfra.examples.recruit.Snapshot.Robot;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.jspecify.annotations.Nullable;

/**
 * Shows on a terminal what each robot is doing, twice a second, by a thread of its own, {@code
 * dfra-demo-live}. Without a terminal it does nothing: the progress reports suffice.
 */
final class LiveView implements AutoCloseable {

  private static final long PERIOD_MILLIS = 500;

  /** Above this height a robot counts as flying, metres above the ground. */
  private static final double FLIES = 0.5;

  private final ProgressReporter progress;
  private final List<String> robots;
  private final Instant began;
  private final InstantSource clock;
  private final LocalFrame frame;
  private final AgentMonitor monitor;
  private final BackgroundSearches searches;
  private final TrueTrajectories ways;
  private final @Nullable BatteryMonitor batteries; // null without a terminal
  private final @Nullable ScheduledExecutorService thread; // likewise

  @GuardedBy("this")
  private boolean isOver;

  /**
   * @param robots from the first line to the last
   * @param began the robots' time at the start of the demonstration
   * @param clock the robots'
   * @param frame the world's
   */
  LiveView(
      ProgressReporter progress,
      List<String> robots,
      Instant began,
      InstantSource clock,
      LocalFrame frame,
      ModuleDirectory directory,
      AgentMonitor monitor,
      BackgroundSearches searches,
      TrueTrajectories ways) {
    this.progress = progress;
    this.robots = List.copyOf(robots);
    this.began = began;
    this.clock = clock;
    this.frame = frame;
    this.monitor = monitor;
    this.searches = searches;
    this.ways = ways;
    this.batteries = progress.isTerminal() ? BatteryMonitor.start(directory) : null;
    this.thread =
        progress.isTerminal()
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
      progress.redraw(SnapshotLines.of(now(), progress.columns() - 1));
    } catch (RuntimeException e) { // the demonstration continues without it
      progress.redraw(List.of("", "The team's state cannot be shown: " + e));
    }
  }

  private Snapshot now() {
    Instant time = clock.instant();
    List<Attempt> conversations = Conversations.of(monitor.messages());
    List<Robot> all = new ArrayList<>();
    @Nullable CallState call = null;
    for (String name : robots) {
      RecruitmentStatus agent = monitor.last(name).orElse(null);
      all.add(robot(name, agent, conversations, time));
      if (agent != null && agent.requesterPhase() != RequesterPhase.IDLE) {
        call = CallState.last(conversations, name).orElse(call);
      }
    }
    return new Snapshot(began, time, all, call);
  }

  private Robot robot(
      String name, @Nullable RecruitmentStatus agent, List<Attempt> conversations, Instant time) {
    GroundTruthPose pose = ways.at(name, time);
    Optional<CallState> served =
        agent == null || agent.helpedRobot() == null
            ? Optional.empty()
            : CallState.last(conversations, agent.helpedRobot())
                .filter(each -> name.equals(each.chosen()));
    @Nullable Double distance = null;
    @Nullable Double lease = null;
    if (agent != null && served.isPresent()) {
      if (agent.responderPhase() == ResponderPhase.TRAVELLING) {
        distance = distance(pose, served.get().place());
      } else if (agent.responderPhase().isCommitted() && served.get().leaseEnd() != null) {
        double left = Duration.between(time, served.get().leaseEnd()).toMillis() / 1000.0;
        lease = Math.max(0, left);
      }
    }
    return new Robot(
        name,
        availability(name),
        pose.up() > FLIES,
        agent,
        searches.last(name).orElse(null),
        distance,
        lease,
        batteries == null ? null : batteries.charge(name));
  }

  private double distance(GroundTruthPose pose, GeoPosition place) {
    LocalPosition there = frame.toLocal(place);
    return Math.hypot(there.east() - pose.east(), there.north() - pose.north());
  }

  private Availability availability(String name) {
    if (monitor.isDead(name)) {
      return Availability.DEAD;
    } else if (monitor.isCutOff(name)) {
      return Availability.UNREACHABLE;
    }
    return monitor.listening().contains(name) ? Availability.PRESENT : Availability.ABSENT;
  }

  /** {@inheritDoc} The last lines stay on the terminal. */
  @Override
  public synchronized void close() {
    if (thread == null || batteries == null || isOver) {
      return;
    }
    thread.shutdown();
    draw();
    isOver = true;
    progress.freezeLive();
    batteries.close();
  }
}
