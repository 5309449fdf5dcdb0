package org.dfra.recruit.agent;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
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
import org.dfra.core.chain.Errands;
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
import org.dfra.persona.StopAttributes;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * What a robot's own modules have told of it last: where it is, its charge, whether it searches or
 * is driven, and whether it is stopped. Safe for use by any threads; asking needs no network.
 *
 * <p>A behaviour that is gone counts no more, and one that has not told anything since it was found
 * is at what its persona says. So is an emergency stop, which is seen half a second after it, and
 * as long after its end.
 */
final class Senses implements AutoCloseable {

  private static final Duration FRESH = Duration.ofSeconds(2);
  private static final Duration BATTERY_FRESH = Duration.ofMinutes(5);

  /** What sends a robot somewhere. */
  private static final List<Class<? extends Behavior<?>>> DRIVING =
      List.of(GoToWaypoint.class, FollowWaypoints.class, ReturnHome.class);

  /** What obeys to those. */
  private static final List<Class<? extends Module>> MOVING =
      List.of(DriveEffector.class, FlightEffector.class);

  /**
   * What a behaviour told last.
   *
   * @param by itself, or its proxy: it is another one after most restarts
   */
  private record Told(Module by, Phase phase) {}

  private final ModuleContext context;
  private final ChainInputs inputs;
  private final Map<UUID, Told> told = new ConcurrentHashMap<>(); // by module
  private volatile @Nullable PoseEstimate pose;
  private volatile @Nullable BatteryState charge;

  Senses(ModuleContext context, Logger log) {
    this.context = context;
    this.inputs =
        new ChainInputs(
            context.path(),
            context::directory,
            new Errands("dfra-inputs " + context.path(), context.scheduler()),
            log);
    String robot = context.robot();
    inputs.declare(
        ModuleQuery.of(PositionEstimator.class).robot(robot),
        false,
        "",
        PoseEstimate.class,
        (source, sequence, estimate) -> pose = estimate);
    inputs.declare(
        ModuleQuery.of(BatterySensor.class).robot(robot),
        false,
        "",
        BatteryState.class,
        (source, sequence, state) -> charge = state);
    watch(RasterSearch.class);
    DRIVING.forEach(this::watch);
  }

  private void watch(Class<? extends Behavior<?>> kind) {
    inputs.declare(
        ModuleQuery.of(kind).robot(context.robot()),
        true,
        "",
        BehaviorStatus.class,
        (source, sequence, status) ->
            told.put(source.id(), new Told(source.module(), status.phase())));
  }

  void start() {
    inputs.wire(List.of());
  }

  @Override
  public void close() {
    inputs.close();
  }

  /** Where it is; null where that is older than {@code FRESH}, or it never knew. */
  @Nullable PoseEstimate pose() {
    PoseEstimate last = pose;
    return last != null && isFresh(last.measured(), FRESH) ? last : null;
  }

  /** Charge left, 0 to 1; 1 where it does not know. */
  double battery() {
    BatteryState last = charge;
    Double remaining =
        last == null || !isFresh(last.measured(), BATTERY_FRESH) ? null : last.remaining();
    return remaining == null ? 1 : remaining;
  }

  /** Whether one of its raster searches runs. */
  boolean isSearching() {
    return listed(RasterSearch.class).stream().anyMatch(each -> phase(each) == Phase.RUNNING);
  }

  /** Whether it is sent somewhere, by whomever, also if it pauses on its way. */
  boolean isDriven() {
    return DRIVING.stream()
        .flatMap(kind -> listed(kind).stream())
        .anyMatch(each -> phase(each).isUnderWay());
  }

  /** Whether something that moves it is stopped for an emergency. */
  boolean isStopped() {
    return MOVING.stream()
        .flatMap(kind -> listed(kind).stream())
        .anyMatch(
            each ->
                each.attributes(StopAttributes.class).filter(StopAttributes::latched).isPresent());
  }

  private <M extends Module> List<ModuleListing<M>> listed(Class<M> kind) {
    return context.directory().find(ModuleQuery.of(kind).robot(context.robot()));
  }

  private Phase phase(ModuleListing<?> behavior) {
    Told last = told.get(behavior.id());
    if (last != null && last.by().equals(behavior.module())) {
      return last.phase();
    }
    String said =
        behavior.attributes(BehaviorAttributes.class).map(BehaviorAttributes::phase).orElse("");
    return Arrays.stream(Phase.values())
        .filter(each -> each.name().equals(said))
        .findFirst()
        .orElse(Phase.IDLE);
  }

  private boolean isFresh(Instant measured, Duration limit) {
    return Duration.between(measured, context.clock().instant()).compareTo(limit) <= 0;
  }
}
