package org.dfra.examples.mission.process;

import java.time.Instant;
import java.util.Objects;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.mission.monitor.FaultInjectionContext;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.jspecify.annotations.Nullable;

/**
 * A process that a robot needs to drive is killed while it drives along a lane at full speed: no
 * process is left to command the wheels to stop, or to forward the command. The wheels still stop
 * in time; the process is restarted, and the robot resumes at the same place.
 *
 * <pre>
 *   PENDING --on a lane, fast--&gt; KILLED --wheels stop--&gt; STOPPED --it drives again--&gt; DONE
 * </pre>
 */
final class ProcessKillOnLane implements InjectedFault<DemoRobot> {

  /** Distance from a lane's ends, metres: between them a robot drives straight. */
  private static final double MIDST = 1.5;

  /** Below this speed it is not at full speed, metres per second. */
  private static final double FAST = 0.6;

  /** From this speed on it drives again, metres per second. */
  private static final double DRIVES = 0.3;

  /** Maximum time from the last command to the stop, seconds of the robot's time. */
  private static final double MOST = 0.5;

  private enum State {
    /** Waits until the robot is at the place of the fault. */
    PENDING,
    /** Waits until the wheels stop. */
    KILLED,
    /** Waits until the robot drives again. */
    STOPPED,
    /** The fault has ended, or will not occur. */
    DONE
  }

  private final int robot;
  private final String group;
  private final double share;
  private final boolean isCommander;
  private final InjectedFault<DemoRobot> before;
  private State state = State.PENDING;

  // known once it is killed
  private Instant killed = Instant.MIN;
  private int waypoints;

  /**
   * @param robot its index, from 0
   * @param group of its service groups
   * @param share of its search after which it is killed
   * @param isCommander whether it commands the wheels, so that the last command is known; else it
   *     forwards commands, and the last received one need not be the last
   * @param before a fault that comes first
   */
  ProcessKillOnLane(
      int robot, String group, double share, boolean isCommander, InjectedFault<DemoRobot> before) {
    this.isCommander = isCommander;
    this.robot = robot;
    this.group = group;
    this.share = share;
    this.before = before;
  }

  @Override
  public void update(FaultInjectionContext<DemoRobot> now) throws Exception {
    SearchingRobot<DemoRobot> victim = now.robots().get(robot);
    switch (state) {
      case PENDING -> lookAhead(now, victim);
      case KILLED -> checkStopped(now, victim);
      case STOPPED -> checkDriving(now, victim);
      default -> {}
    }
  }

  private void lookAhead(FaultInjectionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim)
      throws Exception {
    BehaviorStatus status = victim.subscriptions().latestStatus();
    if (victim.hasEnded()) {
      now.recordEvent(
          now.clock().instant(),
          victim,
          "%s was not killed: after %.0f %% the robot was never fast in the middle of a lane",
          group,
          100 * share);
      state = State.DONE;
      return;
    }
    GroundTruthPose pose = now.truth().last(victim.name());
    if (!before.isOver()
        || status.completion() < share
        || pose.speed() < FAST
        || !victim.isOnLane(now.truePosition(victim), MIDST)) {
      return;
    }
    long process = victim.robot().process(group);
    waypoints = victim.waypoints();
    killed = now.clock().instant();
    victim.robot().host().kill(process);
    now.recordEvent(
        killed,
        victim,
        "%s is killed (process %d) at %.2f m/s in the middle of a lane",
        group,
        process,
        pose.speed());
    state = State.KILLED;
  }

  private void checkStopped(
      FaultInjectionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim) {
    @Nullable Instant stood = now.truth().stoppedSince(victim.name(), killed);
    if (stood == null) {
      return;
    }
    Instant command = Objects.requireNonNullElse(victim.subscriptions().lastCommand(stood), killed);
    double seconds = FaultInjectionContext.seconds(command, stood);
    now.recordEvent(
        stood,
        victim,
        "its wheels have stopped, %.2f s after the last command and %.2f s after %s was killed",
        seconds,
        FaultInjectionContext.seconds(killed, stood),
        group);
    if (isCommander) {
      now.requirement(
          group + " killed: last command to wheels standing (robot's time)", seconds, MOST);
    }
    state = State.STOPPED;
  }

  private void checkDriving(FaultInjectionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim)
      throws Exception {
    GroundTruthPose pose = now.truth().last(victim.name());
    BehaviorStatus status = victim.subscriptions().latestStatus();
    boolean isReceivedAgain = status.measured().isAfter(killed) || victim.hasEnded();
    if (pose.speed() < DRIVES || !isReceivedAgain) {
      return;
    }
    now.recordEvent(
        pose.time(),
        victim,
        "it continues by itself with %d of %d waypoints done, %.1f s after %s was killed (now process"
            + " %d)",
        victim.waypoints(),
        victim.plan().waypoints().size(),
        FaultInjectionContext.seconds(killed, pose.time()),
        group,
        victim.robot().process(group));
    now.figure(
        group + " killed: to driving again",
        FaultInjectionContext.seconds(killed, pose.time()) / now.speed(),
        Double.POSITIVE_INFINITY);
    now.measurements()
        .add(
            new MeasuredValue(
                group + " killed: waypoints to be driven to again",
                Math.max(0, waypoints - victim.waypoints()),
                0,
                ""));
    state = State.DONE;
  }

  @Override
  public boolean hasStarted() {
    return state != State.PENDING;
  }

  @Override
  public boolean isOver() {
    return state == State.DONE;
  }
}
