package org.dfra.app.raster.process;

import java.time.Instant;
import java.util.Objects;
import org.dfra.app.demo.stage.FieldRobot;
import org.dfra.app.figure.Figure;
import org.dfra.app.raster.live.Scene;
import org.dfra.app.raster.live.Searching;
import org.dfra.app.raster.live.Trouble;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.sim.world.TruePose;
import org.jspecify.annotations.Nullable;

/**
 * A process without which a robot cannot drive is killed while it goes along a lane at full speed:
 * nobody is left who could tell the wheels to stop, or nobody who would pass it on. They stand in
 * time all the same; the process comes back, and the robot goes on where it was.
 *
 * <pre>
 *   AHEAD --on a lane, fast--&gt; KILLED --wheels stand--&gt; STANDING --it drives again--&gt; OVER
 * </pre>
 */
final class KilledOnLane implements Trouble<FieldRobot> {

  /** From a lane's ends, metres: in between a robot goes straight on. */
  private static final double MIDST = 1.5;

  /** Slower than this it is not at full speed, metres per second. */
  private static final double FAST = 0.6;

  /** From here on it drives again, metres per second. */
  private static final double DRIVES = 0.3;

  /** Last command to standing, seconds of the robot's time. */
  private static final double MOST = 0.5;

  private enum State {
    /** Waits until the robot is where it is to happen. */
    AHEAD,
    /** Waits until the wheels stand. */
    KILLED,
    /** Waits until the robot drives again. */
    STANDING,
    /** It has happened, or never will. */
    OVER
  }

  private final int robot;
  private final String group;
  private final double share;
  private final boolean isCommander;
  private final Trouble<FieldRobot> before;
  private State state = State.AHEAD;

  // known once it is killed
  private Instant killed = Instant.MIN;
  private int waypoints;

  /**
   * @param robot which one, counted from 0
   * @param group of its service groups
   * @param share of its search after which it is killed
   * @param isCommander whether it commands the wheels, so that the last command is known; else it
   *     passes commands on, and the last that was heard of need not be the last
   * @param before comes first
   */
  KilledOnLane(
      int robot, String group, double share, boolean isCommander, Trouble<FieldRobot> before) {
    this.isCommander = isCommander;
    this.robot = robot;
    this.group = group;
    this.share = share;
    this.before = before;
  }

  @Override
  public void look(Scene<FieldRobot> now) throws Exception {
    Searching<FieldRobot> victim = now.robots().get(robot);
    switch (state) {
      case AHEAD -> lookAhead(now, victim);
      case KILLED -> seeWhetherItStands(now, victim);
      case STANDING -> seeWhetherItDrives(now, victim);
      default -> {}
    }
  }

  private void lookAhead(Scene<FieldRobot> now, Searching<FieldRobot> victim) throws Exception {
    BehaviorStatus status = victim.hearing().newest();
    if (victim.hasEnded()) {
      now.mark(
          now.clock().instant(),
          victim,
          "%s was not killed: after %.0f %% it was never fast in the midst of a lane",
          group,
          100 * share);
      state = State.OVER;
      return;
    }
    TruePose pose = now.truth().last(victim.name());
    if (!before.isOver()
        || status.done() < share
        || pose.speed() < FAST
        || !victim.isOnLane(now.place(victim), MIDST)) {
      return;
    }
    long process = victim.robot().process(group);
    waypoints = victim.waypoints();
    killed = now.clock().instant();
    victim.robot().host().kill(process);
    now.mark(
        killed,
        victim,
        "%s is killed (process %d) at %.2f m/s in the midst of a lane",
        group,
        process,
        pose.speed());
    state = State.KILLED;
  }

  private void seeWhetherItStands(Scene<FieldRobot> now, Searching<FieldRobot> victim) {
    @Nullable Instant stood = now.truth().stoodFrom(victim.name(), killed);
    if (stood == null) {
      return;
    }
    Instant command = Objects.requireNonNullElse(victim.hearing().lastCommand(stood), killed);
    double seconds = Scene.seconds(command, stood);
    now.mark(
        stood,
        victim,
        "its wheels stand, %.2f s after the last command and %.2f s after %s was killed",
        seconds,
        Scene.seconds(killed, stood),
        group);
    if (isCommander) {
      now.requirement(
          group + " killed: last command to wheels standing (robot's time)", seconds, MOST);
    }
    state = State.STANDING;
  }

  private void seeWhetherItDrives(Scene<FieldRobot> now, Searching<FieldRobot> victim)
      throws Exception {
    TruePose pose = now.truth().last(victim.name());
    BehaviorStatus status = victim.hearing().newest();
    boolean isHeardAgain = status.measured().isAfter(killed) || victim.hasEnded();
    if (pose.speed() < DRIVES || !isHeardAgain) {
      return;
    }
    now.mark(
        pose.time(),
        victim,
        "it goes on by itself with %d of %d waypoints done, %.1f s after %s was killed (now process"
            + " %d)",
        victim.waypoints(),
        victim.plan().waypoints().size(),
        Scene.seconds(killed, pose.time()),
        group,
        victim.robot().process(group));
    now.figure(
        group + " killed: to driving again",
        Scene.seconds(killed, pose.time()) / now.speed(),
        Double.POSITIVE_INFINITY);
    now.figures()
        .add(
            new Figure(
                group + " killed: waypoints to be driven to again",
                Math.max(0, waypoints - victim.waypoints()),
                0,
                ""));
    state = State.OVER;
  }

  @Override
  public boolean hasBegun() {
    return state != State.AHEAD;
  }

  @Override
  public boolean isOver() {
    return state == State.OVER;
  }
}
