package org.dfra.behaviors;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behaviors.motor.FuzzyDriveImpl;
import org.dfra.behaviors.perceptual.heading.HeadingErrorImpl;
import org.dfra.behaviors.waypoint.GoToWaypointImpl;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.module.PerceptualSchemaImpl;
import org.dfra.core.state.StateStore;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.perceptual.RangeFilter;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.DriveAttributes;
import org.dfra.persona.PerceptualSchemaAttributes;

/**
 * A robot whose percepts the test sets, and whose body moves as its wheels drive it, unless it is
 * held. It moves and perceives ten times a second. Its time is stepped.
 */
public final class ScriptedRobot implements AutoCloseable {

  public static final GeoPosition DATUM = new GeoPosition(48, 11, 0);
  public static final String NAME = "atrv1";

  private static final LocalFrame FRAME = new LocalFrame(DATUM);
  private static final double TICK = 0.1;

  public final SteppedTime time = new SteppedTime();
  public final InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time);
  public final Map<String, StateStore> states = new HashMap<>();
  private final Map<String, MortalTime> times = new HashMap<>();
  public final Drive drive = new Drive(context("drive", Map.of()));
  public final Place position = new Place(context("position", Map.of()));
  public final Room clearance = new Room("range_filter");

  public double east;
  public double north;
  public double yaw;
  public double yawSigma = 0.02;
  public double ahead = 8;
  public boolean isHeld;
  public Duration roomDelay = Duration.ZERO;

  /** Which of its range filters publishes the clearance. */
  public Room seer = clearance;

  public boolean seesRoom = true;
  public boolean seesPlace = true;

  private final Map<ModuleImpl, DirectoryRegistration> modules = new HashMap<>();
  private final List<ModuleImpl> order = new ArrayList<>();

  /** With wheels, position, clearance, heading error and fuzzy rules; without a behaviour. */
  public ScriptedRobot() {
    add(drive);
    add(position);
    add(clearance);
    add(new HeadingErrorImpl(context("heading_error", Map.of())));
    add(new FuzzyDriveImpl(context("fuzzy_drive", Map.of("system_file", rules().toString()))));
    tick();
    time.step(0.5);
  }

  public static Path rules() {
    return Path.of(System.getProperty("dfra.root", "."), "config", "fuzzy", "waypoint.fis");
  }

  public ModuleContext context(String name, Map<String, String> parameters) {
    return context(name, Parameters.of(NAME + "/" + name, parameters));
  }

  public ModuleContext context(String name, Parameters parameters) {
    StateStore state = states.computeIfAbsent(name, unused -> StateStore.inMemory());
    MortalTime own = new MortalTime(time);
    times.put(name, own);
    return new ModuleContext(NAME, name, parameters, own, state).withDirectory(directory);
  }

  /** Sets the clock of a module's computer this far ahead of the others'. */
  public void setAhead(String module, Duration span) {
    Objects.requireNonNull(times.get(module), module).setAhead(span);
  }

  /** Starts a module and lists it. */
  public <M extends ModuleImpl> M add(M module) {
    module.start();
    show(module);
    return module;
  }

  /** Its process ends. */
  public void end(ModuleImpl module) {
    hide(module);
    module.close();
  }

  /** It cannot be found any more, though it still runs. */
  public void hide(ModuleImpl module) {
    modules.remove(module).close();
    order.remove(module);
  }

  /** It is found again. */
  public void show(ModuleImpl module) {
    modules.put(module, directory.add(module));
    order.add(0, module);
  }

  /** Its process is killed: it does nothing more, and does not release what it holds. */
  public void kill(ModuleImpl module, String name) {
    times.get(name).die();
    hide(module);
  }

  public GoToWaypointImpl addGoTo(Map<String, String> parameters) {
    return add(new GoToWaypointImpl(context("go_to_waypoint", parameters)));
  }

  /** Steps until a behaviour is in this phase. */
  public boolean reaches(BehaviorImpl<?> behavior, BehaviorStatus.Phase phase, double seconds) {
    return time.until(() -> behavior.status().phase() == phase, seconds);
  }

  /** Steps until this is part of the activity that a behaviour reports. */
  public boolean reachesActivity(BehaviorImpl<?> behavior, String part, double seconds) {
    return time.until(() -> behavior.status().activity().contains(part), seconds);
  }

  public static GeoPosition at(double east, double north) {
    return FRAME.toGeo(new LocalPosition(east, north, 0));
  }

  public double distanceTo(double toEast, double toNorth) {
    return Math.hypot(toEast - east, toNorth - north);
  }

  private void tick() {
    Velocity turning = drive.turning;
    if (!isHeld) {
      yaw += turning.yawRate() * TICK;
      east += turning.speed() * Math.cos(yaw) * TICK;
      north += turning.speed() * Math.sin(yaw) * TICK;
    }
    if (seesPlace) {
      position.see(
          new PoseEstimate(
              time.instant(),
              NAME + "/map",
              DATUM,
              east,
              north,
              Math.IEEEremainder(yaw, 2 * Math.PI),
              turning.speed(),
              turning.yawRate(),
              0.1,
              yawSigma,
              null,
              null));
    }
    if (seesRoom) {
      seer.see(new Clearance(time.instant().minus(roomDelay), NAME + "/base_link", 8, ahead, 8));
    }
    Object unused = time.after(Math.round(TICK * 1e9), this::tick);
  }

  @Override
  public void close() {
    List.copyOf(order).forEach(this::end);
    directory.close();
  }

  /** Wheels that record the velocities and brake commands that they receive. */
  public static final class Drive extends DriveImpl {

    public final List<Velocity> velocities = new ArrayList<>();

    /** What the brake was commanded; true to set it. */
    public final List<Boolean> braked = new ArrayList<>();

    public Velocity turning = Velocity.ZERO;

    Drive(ModuleContext context) {
      super(
          context,
          "scripted wheels",
          "DFRA",
          "1",
          new DriveAttributes(1, 2, 0.78, 0.64),
          0.1,
          List.of());
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {}

    @Override
    protected void setVelocity(Velocity wanted) {
      velocities.add(wanted);
      turning = wanted;
    }

    @Override
    protected void halt() {
      turning = Velocity.ZERO;
    }

    @Override
    protected void brake(boolean set) {
      braked.add(set);
    }

    /** Somebody sets or releases the brake by a switch on the robot. */
    public void switchBrake(boolean set) {
      brakeReported(set);
    }

    /** Its controller is switched off, and has its brake set when it is switched on. */
    public void switchOff() {
      transitionTo(Readiness.INITIALIZING, "its controller was switched off");
      deviceReset(true);
      turning = Velocity.ZERO;
    }

    public void switchOn() {
      transitionTo(Readiness.READY);
    }
  }

  /** Publishes the pose that the test sets. */
  public static final class Place extends PerceptualSchemaImpl<PoseEstimate>
      implements PositionEstimator {

    Place(ModuleContext context) {
      super(context, "a place", "DFRA", "1", PoseEstimate.class, "PoseEstimate", 0.5);
    }

    public void see(PoseEstimate pose) {
      publishPercept(pose);
    }

    @Override
    protected PerceptualSchemaAttributes schemaAttributes() {
      return new PerceptualSchemaAttributes("PoseEstimate", null, "scripted", null, null);
    }

    @Override
    public PoseEstimate estimate() {
      return percept();
    }
  }

  /** Publishes the clearance that the test sets. */
  public final class Room extends PerceptualSchemaImpl<Clearance> implements RangeFilter {

    public Room(String name) {
      super(
          ScriptedRobot.this.context(name, Map.of()),
          "room",
          "DFRA",
          "1",
          Clearance.class,
          "Clearance",
          0.5);
    }

    public void see(Clearance clearance) {
      publishPercept(clearance);
    }

    @Override
    protected PerceptualSchemaAttributes schemaAttributes() {
      return new PerceptualSchemaAttributes("Clearance", null, "scripted", null, null);
    }

    @Override
    public Clearance clearance() {
      return percept();
    }
  }
}
