package org.dfra.examples.recruit;

import java.time.Duration;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.ReturnToLaunch;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightEffector;
import org.dfra.flow.effector.FlightState;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;

/** A robot that observes from above, and hovers over targets that need inspection from near. */
final class HoverCaller implements AutoCloseable {

  private static final Duration PATIENCE = HelpRequester.PATIENCE;

  /** After which it holds its position if this process dies. */
  private static final Duration LEASE = Duration.ofSeconds(10);

  private static final double HEIGHT = 8; // metres above the ground
  private static final double SPEED = 4; // metres per second
  private static final double NEAR = 1; // metres: counts as arrived

  private final ProgressReporter progress;
  private final String robot;
  private final FlightEffector flight;
  private final LocalFrame frame;
  private final CommandLease lease;

  /**
   * Takes off.
   *
   * @param frame the world's
   */
  HoverCaller(ProgressReporter progress, String robot, FlightEffector flight, LocalFrame frame)
      throws Exception {
    this.progress = progress;
    this.robot = robot;
    this.flight = flight;
    this.frame = frame;
    progress.step("having " + robot + " take off");
    DemoAssertions.await(
        "that " + robot + " has a position",
        PATIENCE,
        () -> flight.flightState().position() != null);
    this.lease = flight.acquireCommandLease(LEASE);
    flight.execute(lease.key(), new Arm());
    DemoAssertions.await("that its motors run", PATIENCE, () -> flight.flightState().isArmed());
    flight.execute(lease.key(), new TakeOff(HEIGHT));
    DemoAssertions.await(
        "that it flies", PATIENCE, () -> flight.flightState().phase() == Phase.IN_AIR);
    progress.say("%s takes off, and flies %.0f m above the field.", robot, HEIGHT);
  }

  /** Flies over a place, and hovers there. */
  void lookAt(GeoPosition place) throws Exception {
    LocalPosition on = frame.toLocal(place);
    progress.step("flying " + robot + " over an object");
    LocalPosition above = new LocalPosition(on.east(), on.north(), HEIGHT);
    flight.execute(lease.key(), new GoTo(frame.toGeo(above), SPEED));
    DemoAssertions.await("that " + robot + " is there", PATIENCE, () -> isOver(on));
    progress.say(
        "%s hovers over an object %.0f m east and %.0f m north; from above it could be a mine or a stone.",
        robot, on.east(), on.north());
  }

  private boolean isOver(LocalPosition place) throws Exception {
    FlightState state = flight.flightState();
    if (state.position() == null) {
      return false;
    }
    LocalPosition at = frame.toLocal(state.position());
    return Math.hypot(at.east() - place.east(), at.north() - place.north()) < NEAR;
  }

  /** Flies back, and lands. */
  void land() throws Exception {
    progress.step("having " + robot + " land");
    flight.execute(lease.key(), new ReturnToLaunch());
    DemoAssertions.await(
        "that " + robot + " has landed",
        PATIENCE,
        () -> flight.flightState().phase() == Phase.ON_GROUND && !flight.flightState().isArmed());
    progress.say("%s has landed where it took off.", robot);
  }

  /** {@inheritDoc} If it still flies, it holds its position. */
  @Override
  public void close() throws Exception {
    lease.close();
  }
}
