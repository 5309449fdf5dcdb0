package org.dfra.recruit.agent;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.RasterSearch;
import org.dfra.behavior.ReturnHome;
import org.dfra.core.chain.ChainInputs;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.FlightEffector;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.BatteryState;
import org.dfra.module.Module;
import org.dfra.persona.BehaviorAttributes;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * The last reports of a robot's own modules: its position, its charge, whether it searches or is
 * driven, and whether it is stopped. Thread-safe; queries need no network.
 *
 * <p>An unregistered behaviour is ignored; for one without a report since its discovery, the
 * persona gives the status. So it is for an emergency stop, which is visible with a delay of half a
 * second, at its start and its end.
 */
final class RobotStateMonitor implements AutoCloseable {

  private static final Duration FRESH = Duration.ofSeconds(2);
  private static final Duration BATTERY_FRESH = Duration.ofMinutes(5);

  /** Receives each start or resume of a behaviour's goal. */
  @FunctionalInterface
  interface GoalListener {

    /** The goal was started, or resumed, at that time; called on a delivery thread. */
    void goalStarted(ModuleListing<?> behavior, BehaviorStatus status);
  }

  /** Behaviours that drive a robot to a place. */
  private static final List<Class<? extends Behavior<?>>> DRIVING =
      List.of(GoToWaypoint.class, FollowWaypoints.class, ReturnHome.class);

  /** Effectors that execute their commands. */
  private static final List<Class<? extends Module>> MOVING =
      List.of(DriveEffector.class, FlightEffector.class);

  /**
   * A behaviour's last status.
   *
   * @param module the module or its proxy: usually another object after a restart
   */
  private record LastStatus(Module module, BehaviorStatus status) {

    /** Whether the goal was started since then, or was resumed. */
    boolean isNewGoal(BehaviorStatus fresh) {
      return status.phase() != Phase.RUNNING || !Objects.equals(status.goal(), fresh.goal());
    }
  }

  /**
   * The last value of its kind. Its age is computed from its reception time: the sender's clock may
   * have been set since.
   *
   * @param nanos its reception time, by the robot's monotonic time
   */
  private record Received<R>(R reading, long nanos) {}

  private final ModuleContext context;
  private final ChainInputs inputs;
  private final Map<UUID, LastStatus> reported = new ConcurrentHashMap<>(); // by module
  private volatile @Nullable Received<PoseEstimate> pose;
  private volatile @Nullable Received<BatteryState> charge;

  private final GoalListener listener;

  RobotStateMonitor(ModuleContext context, GoalListener listener, Logger log) {
    this.context = context;
    this.listener = listener;
    this.inputs = new ChainInputs(context.path(), context::directory, context.scheduler(), log);
    String robot = context.robot();
    inputs.declareOne(
        ModuleQuery.of(PositionEstimator.class).robot(robot),
        "",
        PoseEstimate.class,
        (source, sequence, estimate) -> pose = received(estimate));
    inputs.declareOne(
        ModuleQuery.of(BatterySensor.class).robot(robot),
        "",
        BatteryState.class,
        (source, sequence, state) -> charge = received(state));
    watch(RasterSearch.class);
    DRIVING.forEach(this::watch);
  }

  private void watch(Class<? extends Behavior<?>> kind) {
    inputs.declareAll(
        ModuleQuery.of(kind).robot(context.robot()),
        BehaviorStatus.class,
        (source, sequence, status) -> take(source, status));
  }

  private void take(ModuleListing<?> source, BehaviorStatus status) {
    @Nullable LastStatus last = reported.put(source.id(), new LastStatus(source.module(), status));
    if (status.phase() == Phase.RUNNING && (last == null || last.isNewGoal(status))) {
      listener.goalStarted(source, status);
    }
  }

  void start() {
    inputs.wire(List.of());
  }

  @Override
  public void close() {
    inputs.close();
  }

  private <R> Received<R> received(R reading) {
    return new Received<>(reading, context.robotTime().nanos());
  }

  /** Its position; null where that is older than {@code FRESH}, or unknown. */
  @Nullable PoseEstimate pose() {
    @Nullable Received<PoseEstimate> last = pose;
    return last != null && isFresh(last, FRESH) ? last.reading() : null;
  }

  /** Charge left, 0 to 1; 1 where it is unknown. */
  double battery() {
    @Nullable Received<BatteryState> last = charge;
    @Nullable Double remaining =
        last == null || !isFresh(last, BATTERY_FRESH) ? null : last.reading().remaining();
    return remaining == null ? 1 : remaining;
  }

  /** Whether one of its raster searches is running. */
  boolean isSearching() {
    return listed(RasterSearch.class).stream().anyMatch(each -> phase(each) == Phase.RUNNING);
  }

  /** Whether any client has sent it to a place, even if it is paused on its way. */
  boolean isDriving() {
    return DRIVING.stream()
        .flatMap(kind -> listed(kind).stream())
        .anyMatch(each -> phase(each).isUnderWay());
  }

  /** The effectors that move it. */
  List<ModuleListing<? extends Module>> effectors() {
    List<ModuleListing<? extends Module>> all = new ArrayList<>();
    MOVING.forEach(kind -> all.addAll(listed(kind)));
    return all;
  }

  /** The behaviours that drive it to a place, and its searches. */
  List<ModuleListing<? extends Behavior<?>>> behaviors() {
    List<ModuleListing<? extends Behavior<?>>> all = new ArrayList<>(listed(RasterSearch.class));
    DRIVING.forEach(kind -> all.addAll(listed(kind)));
    return all;
  }

  /** Since when a behaviour's goal is held; null where it is not. */
  @Nullable Instant heldSince(ModuleListing<?> behavior) {
    LastStatus last = lastStatus(behavior);
    return last != null
        ? last.status().heldSince()
        : behavior
            .attributes(BehaviorAttributes.class)
            .map(BehaviorAttributes::heldSince)
            .orElse(null);
  }

  private @Nullable LastStatus lastStatus(ModuleListing<?> behavior) {
    LastStatus last = reported.get(behavior.id());
    return last != null && last.module().equals(behavior.module()) ? last : null;
  }

  private <M extends Module> List<ModuleListing<M>> listed(Class<M> kind) {
    return context.directory().find(ModuleQuery.of(kind).robot(context.robot()));
  }

  private Phase phase(ModuleListing<?> behavior) {
    LastStatus last = lastStatus(behavior);
    if (last != null) {
      return last.status().phase();
    }
    String reported =
        behavior.attributes(BehaviorAttributes.class).map(BehaviorAttributes::phase).orElse("");
    return Arrays.stream(Phase.values())
        .filter(each -> each.name().equals(reported))
        .findFirst()
        .orElse(Phase.IDLE);
  }

  private boolean isFresh(Received<?> last, Duration limit) {
    return context.robotTime().nanos() - last.nanos() <= limit.toNanos();
  }
}
