package org.dfra.drivers.pantilt.ptu;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.effector.EffectorImpl;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.pantilt.ptu.PtuCommands.PtuAxis;
import org.dfra.drivers.pantilt.ptu.PtuGeometryQuery.PtuGeometry;
import org.dfra.flow.effector.PanTiltCommand;
import org.dfra.flow.effector.PanTiltCommand.Halt;
import org.dfra.flow.effector.PanTiltCommand.PointAt;
import org.dfra.flow.effector.PanTiltEffector;
import org.dfra.flow.effector.PanTiltState;
import org.dfra.geometry.Transform;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.EffectorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A pan-tilt unit of Directed Perception, PTU-46 or D46, on a serial link: 9600 8N1.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code link}, {@code reopen_initial_delay}, {@code reopen_max_delay}: see {@link
 *       org.dfra.drivers.link.LinkSettings}; the link is required
 *   <li>{@code rate}: how often the position is queried, {@value #SLOWEST} to {@value #FASTEST} Hz;
 *       default {@value #USUAL}; can be set while it runs
 *   <li>{@code mount_frame}, {@code mount_x} and so on: the intersection of the two axes, and the
 *       head's orientation at 0, 0; see {@link org.dfra.core.module.DeviceImpl}
 *   <li>read-only: {@code refused_commands}, number of commands that the unit rejected; {@code
 *       frames}, {@code dropped_bytes}, {@code malformed_frames}
 * </ul>
 *
 * <p>The head's frame moves with it: {@link #localTransform} is the mount, then pan about z, to the
 * left +, then tilt about y, up + (which is a negative pitch, since nose down is + there).
 *
 * <p>The module is INITIALIZING until the unit has reported the limits and positions of its axes,
 * and again when the link is lost, when it reports no position for 3 s, or while it is reset. It is
 * FAILED when an axis runs into its end stop ({@code !P}, {@code !T}): the unit has lost steps, and
 * its positions are wrong, until the recovery {@code reset_by_moving}.
 *
 * <p>A direction outside the unit's limits is rejected; a speed outside them is limited. Without a
 * commander the head halts.
 *
 * <p>Tests: {@code link}, {@code readings} (positions arrive), {@code identification} (it reports
 * its version). Recoveries: {@code reopen_link}; {@code reset_by_moving}, which moves the head to
 * all its end stops and then to 0, 0, and is rejected while a client commands the unit or during an
 * emergency stop.
 *
 * <p>Threads: one reader ({@code name reader}), owned from {@code start} to {@code close}. Commands
 * are sent on the caller's thread.
 */
public final class PtuImpl extends EffectorImpl<PanTiltCommand> implements PanTiltEffector {

  static final double SLOWEST = 0.5;
  static final double FASTEST = 20;
  static final double USUAL = 10;

  /** Its payload and environment, from the manufacturer's data sheet. */
  private static final List<Precondition> PRECONDITIONS =
      List.of(
          new Precondition("load on the head", 0, 1.81, "kg"),
          new Precondition("temperature", -20, 60, "°C"));

  /** Commanded positions of the head. */
  private record Target(int pan, int tilt) {}

  private static final Duration OLDEST = Duration.ofSeconds(3);

  private final LatestReading<PanTiltState> latest;
  private final DeviceLink deviceLink;
  private final PtuProtocol protocol;
  private final PtuDiagnostics diagnostics;

  private volatile double rate;
  private volatile @Nullable PtuGeometry geometry; // null: not reported yet
  private volatile @Nullable Target target; // null: it was halted, or never commanded
  private volatile long refusals;

  // confined to the reader
  private int lastPan;
  private int lastTilt;

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public PtuImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  PtuImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "pan-tilt unit, Directed Perception PTU-46",
        "DFRA",
        "1.0",
        List.of("Halt", "PointAt"),
        List.of("PanTiltState"),
        PRECONDITIONS);
    this.latest =
        new LatestReading<>("position", this, this::transitionTo, ticker::nanos, () -> OLDEST);
    this.rate = settings().number("rate", USUAL, SLOWEST, FASTEST);
    this.protocol = new PtuProtocol(new Unit(), ticker, () -> rate, this::send);
    this.deviceLink = new DeviceLink(context, protocol, ticker, source, log);
    this.deviceLink.declareIn(diagnostics(), parameterTable());
    this.diagnostics =
        new PtuDiagnostics(
            deviceLink, protocol, this::commander, () -> emergencyStopState().latched());
    this.diagnostics.declareIn(diagnostics());
    parameterTable()
        .declareNumber(
            "rate",
            "how often it is asked where the head points",
            ParameterTable.NumberRange.of(SLOWEST, FASTEST, "Hz"),
            () -> rate,
            value -> rate = value);
    parameterTable()
        .declareReadOnly(
            "refused_commands", "commands that the unit refused", () -> Long.toString(refusals));
  }

  private boolean send(byte[] bytes) {
    return deviceLink.sendNow(bytes);
  }

  @Override
  protected void onStart() {
    latest.setMissing("its link is being opened");
    deviceLink.start();
  }

  @Override
  protected void onClose() {
    deviceLink.close();
    latest.clear("it has ended");
  }

  @Override
  protected void execute(PanTiltCommand command) {
    PtuGeometry known = geometry;
    if (known == null) {
      throw new NotReadyException(path(), readiness(), latest.missing());
    }
    if (command instanceof PointAt point) {
      point(point, known);
    } else if (command instanceof Halt) {
      target = null;
      sendToUnit(List.of(PtuCommands.HALT));
    }
  }

  private void point(PointAt point, PtuGeometry known) {
    Target request;
    try {
      request = new Target(known.pan().position(point.pan()), known.tilt().position(point.tilt()));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(path() + " cannot point there: " + e.getMessage(), e);
    }
    haltExecutor().prepare(); // a motion that could not be halted later is not started
    target = request;
    sendToUnit(
        PtuCommands.point(
            request.pan(),
            request.tilt(),
            known.pan().speed(point.speed()),
            known.tilt().speed(point.speed())));
  }

  private void sendToUnit(List<String> commands) {
    if (!protocol.send(commands)) {
      throw new NotReadyException(
          path(), readiness(), "its link was lost just now, so the command was not sent");
    }
  }

  /**
   * Halts the head; bypasses a blocked write of the reader. Without a link the halt cannot be sent,
   * and the head stops at its commanded direction.
   */
  @Override
  protected void stopSafely() {
    target = null;
    boolean unused = protocol.halt();
  }

  /** {@inheritDoc} Halts it by another path through the link, if there is one. */
  @Override
  protected void stopDuringCommand() {
    target = null;
    boolean unused = protocol.sendImmediately(List.of(PtuCommands.HALT));
  }

  @Override
  public PanTiltState panTiltState() {
    return latest.get();
  }

  /**
   * {@inheritDoc}
   *
   * @throws NotReadyException as {@link #panTiltState}: then the head's direction is unknown
   */
  @Override
  public Transform localTransform() {
    PanTiltState now = panTiltState();
    return HeadPose.of(super.localTransform(), now.pan(), now.tilt());
  }

  @Override
  protected List<? extends Attributes> deviceAttributes() {
    List<Attributes> all = new ArrayList<>();
    all.add(
        new EffectorAttributes(
            inputTypes(), null, List.of("Nothing is in the way of the head and what it carries.")));
    PtuGeometry known = geometry;
    if (known != null) {
      all.add(known.attributes());
    }
    return all;
  }

  /** Handles the unit's replies; on the reader thread. */
  private final class Unit implements PtuProtocol.Listener {

    @Override
    public void geometryReceived(PtuGeometry reported) {
      geometry = reported;
    }

    @Override
    public void positionReceived(int pan, int tilt) {
      PtuGeometry known = geometry;
      if (known == null || readiness() == Readiness.FAILED) {
        return;
      }
      Target request = target;
      boolean isMoving =
          request == null
              ? latest.peek() != null && (pan != lastPan || tilt != lastTilt)
              : pan != request.pan() || tilt != request.tilt();
      lastPan = pan;
      lastTilt = tilt;
      PanTiltState state =
          new PanTiltState(
              clock().instant(),
              frame(),
              known.pan().radians(pan),
              known.tilt().radians(tilt),
              isMoving);
      latest.set(state);
      publish(state);
    }

    @Override
    public void limitHit(PtuAxis axis) {
      String reason =
          "the "
              + axis
              + " axis ran against its end, and the unit lost count of its steps; recover it by"
              + " reset_by_moving";
      unknown(reason);
      if (readiness().canTransitionTo(Readiness.FAILED)) {
        transitionTo(Readiness.FAILED, reason);
      }
    }

    @Override
    public void resetting() {
      unknown("it is being reset");
      if (readiness() == Readiness.FAILED || readiness().serves()) {
        transitionTo(Readiness.INITIALIZING, "it is being reset");
      }
    }

    @Override
    public void refused(String command, String reason) {
      refusals = refusals + 1; // only the reader counts
      log.warn("{}: the unit refused {}: {}", path(), command, reason);
    }

    @Override
    public void answered(String question, PtuReply reply) {
      diagnostics.answered(question, reply);
    }

    @Override
    public void inconsistentReply(String how) {
      log.warn("{}: {}; it is queried again", path(), how);
      if (readiness() == Readiness.INITIALIZING) {
        latest.setMissing(how);
      }
    }

    @Override
    public void lost(String reason) {
      if (readiness() != Readiness.FAILED) {
        target = null;
        latest.markLost(reason);
      }
    }

    @Override
    public void alive() {
      deviceLink.reportAlive();
    }

    private void unknown(String reason) {
      target = null;
      latest.clear(reason);
    }
  }

  /** Computes the pose of a pan-tilt head. */
  static final class HeadPose {

    private HeadPose() {}

    /**
     * The mount, then pan about its z axis, then tilt about the resulting y axis: transforms
     * coordinates from the head's frame to the frame in which the unit is mounted.
     *
     * @param mount the intersection of the axes, and the head's orientation at 0, 0
     * @param pan radians, to the left is +
     * @param tilt radians, up is +
     */
    static Transform of(Transform mount, double pan, double tilt) {
      Transform turn = Transform.of(0, 0, 0, 0, -tilt, pan); // pitch is + nose down
      double w = mount.qw();
      double x = mount.qx();
      double y = mount.qy();
      double z = mount.qz();
      return new Transform(
          mount.x(),
          mount.y(),
          mount.z(),
          w * turn.qw() - x * turn.qx() - y * turn.qy() - z * turn.qz(),
          w * turn.qx() + x * turn.qw() + y * turn.qz() - z * turn.qy(),
          w * turn.qy() - x * turn.qz() + y * turn.qw() + z * turn.qx(),
          w * turn.qz() + x * turn.qy() - y * turn.qx() + z * turn.qw());
    }
  }
}
