package org.dfra.recruit.agent;

import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import org.dfra.behavior.FollowWaypoints;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.Goal;
import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.PathGoal;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.behavior.ReturnHome;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.BehaviorImpl.RequestedBy;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.module.PerceptualSchemaImpl;
import org.dfra.core.module.SensorImpl;
import org.dfra.core.state.StateStore;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.Locality;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.BatteryState;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PerceptualSchemaAttributes;
import org.dfra.recruit.transport.VirtualTime;
import org.jspecify.annotations.Nullable;

/** The modules of a robot's body, each controlled by the test, all in virtual time. */
final class BodyModules implements AutoCloseable {

  static final String ROBOT = "ugv1";
  static final GeoPosition DATUM = new GeoPosition(48, 11, 0);

  final VirtualTime time = new VirtualTime(Instant.parse("2026-11-21T00:00:00Z"));
  final InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time);

  /** By how much somebody has set the wall clock. */
  Duration set = Duration.ZERO;

  private final Map<String, StateStore> kept = new HashMap<>();
  private final Map<ModuleImpl, DirectoryRegistration> listed = new HashMap<>();

  ModuleContext context(String name) {
    return new ModuleContext(
            ROBOT,
            name,
            Parameters.of(ROBOT + "/" + name, Map.of()),
            this::wall,
            kept.computeIfAbsent(name, unused -> StateStore.inMemory()),
            LeaseTerms.DEFAULT,
            time)
        .withDirectory(directory);
  }

  /** What the wall clock says. */
  Instant wall() {
    return time.instant().plus(set);
  }

  /** What a module of that name kept is lost. */
  void forget(String name) {
    kept.remove(name);
  }

  <M extends ModuleImpl> M add(M module) {
    module.start();
    show(module);
    return module;
  }

  /** It is in the directory, again. */
  void show(ModuleImpl module) {
    listed.put(module, directory.add(module));
  }

  /** It still runs, but cannot be found. */
  void hide(ModuleImpl module) {
    listed.remove(module).close();
  }

  /** Its process ends. */
  void end(ModuleImpl module) {
    hide(module);
    module.close();
  }

  /** Lists what is no module of this virtual machine, or what is known of it now. */
  void list(UUID id, String name, Module module, Attributes... further) {
    List<Attributes> all = new ArrayList<>(List.of(further));
    Instant now = time.instant();
    all.add(
        new ModuleAttributes(
            ROBOT, name, "driver", "localhost", "DFRA", "1", Readiness.READY, now, now, 0));
    directory.put(id, module, all, Locality.SAME_VM);
  }

  /**
   * A module that is out of reach.
   *
   * @param first happens before each call fails
   */
  static <M extends Module> M stub(Class<M> kind, Runnable first) {
    return kind.cast(
        Proxy.newProxyInstance(
            kind.getClassLoader(),
            new Class<?>[] {kind},
            (proxy, method, args) ->
                switch (method.getName()) {
                  case "equals" -> proxy == args[0];
                  case "hashCode" -> System.identityHashCode(proxy);
                  case "toString" -> "a " + kind.getSimpleName();
                  default -> {
                    first.run();
                    throw new RemoteException("it is out of reach");
                  }
                }));
  }

  /** Waits, also where it is interrupted, as a call of another module may. */
  static void awaitAnyway(CountDownLatch latch) {
    boolean interrupted = false;
    while (true) {
      try {
        latch.await();
        break;
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  void step(double seconds) {
    time.advance(Duration.ofNanos(Math.round(seconds * 1e9)));
  }

  static GeoPosition at(double east, double north) {
    return new LocalFrame(DATUM).toGeo(new LocalPosition(east, north, 0));
  }

  @Override
  public void close() {
    List.copyOf(listed.keySet()).forEach(this::end);
    directory.close();
  }

  /** Publishes the pose that the test sets. */
  static final class Position extends PerceptualSchemaImpl<PoseEstimate>
      implements PositionEstimator {

    private final ModuleContext context;

    Position(ModuleContext context) {
      super(context, "a position", "DFRA", "1", PoseEstimate.class, "PoseEstimate", 0.5);
      this.context = context;
    }

    /** Metres from the datum. */
    void see(double east, double north) {
      Instant now = context.clock().instant();
      publishPercept(
          new PoseEstimate(
              now, ROBOT + "/map", DATUM, east, north, 0, 0, 0, 0.1, 0.02, null, null));
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

  /** Publishes the charge that the test sets. */
  static final class Battery extends SensorImpl implements BatterySensor {

    Battery(ModuleContext context) {
      super(context, "a battery", "DFRA", "1", List.of("BatteryState"), List.of());
    }

    /** Share of its charge, 0 to 1; null where it is unknown. */
    void see(@Nullable Double remaining) {
      publish(new BatteryState(clock().instant(), 25, null, remaining, false));
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {}

    @Override
    public double updateRate() {
      return 1;
    }

    @Override
    public BatteryState battery() {
      throw new AssertionError("it is listened to, not asked");
    }
  }

  /** A behaviour whose progress the test sets. */
  abstract static class ScriptedBehavior<G extends Goal> extends BehaviorImpl<G> {

    @Nullable G goal;

    /** For each request for a goal, or to resume one, whether an operator sent it. */
    final List<Boolean> attended = new ArrayList<>();

    GoalProgress progress = GoalProgress.inProgress("it is on its way", 0.5);

    ScriptedBehavior(ModuleContext context, Class<G> type) {
      super(context, "a behaviour", "DFRA", "1", type, 10);
    }

    @Override
    protected void prepare(RequestedBy requester) {
      attended.add(requester == RequestedBy.OPERATOR);
    }

    @Override
    protected GoalExecution startGoal(G wanted) {
      goal = wanted;
      progress = GoalProgress.inProgress("it is on its way", 0.5);
      return new GoalExecution() {
        @Override
        public GoalProgress step() {
          return progress;
        }

        @Override
        public void suspend() {}
      };
    }
  }

  /** Drives, as it seems to its client. */
  static final class Driver extends ScriptedBehavior<LegGoal> implements GoToWaypoint {

    /** The last limit that it was given on the way. */
    volatile @Nullable Duration limit;

    Driver(ModuleContext context) {
      super(context, LegGoal.class);
    }

    @Override
    public void setTimeLimit(UUID wanted, Duration within) {
      if (wanted.equals(status().goal())) {
        limit = within;
      }
    }
  }

  /** Follows a path, likewise. */
  static final class Follower extends ScriptedBehavior<PathGoal> implements FollowWaypoints {
    Follower(ModuleContext context) {
      super(context, PathGoal.class);
    }
  }

  /** Drives home, likewise. */
  static final class Homing extends ScriptedBehavior<HomeGoal> implements ReturnHome {
    Homing(ModuleContext context) {
      super(context, HomeGoal.class);
    }
  }

  /** Searches, likewise. */
  static final class Search extends ScriptedBehavior<RasterGoal> implements RasterSearch {
    Search(ModuleContext context) {
      super(context, RasterGoal.class);
    }
  }
}
