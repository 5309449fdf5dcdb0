package org.dfra.examples.mission.embedded;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.core.time.RobotTime;
import org.dfra.examples.mission.FewLanes;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.RecordingMissionListener;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.SparseField;
import org.dfra.examples.mission.SparseField.Start;
import org.dfra.examples.mission.embedded.RegistrarOutage.RegistrarContents;
import org.dfra.examples.mission.monitor.FaultInjectionContext;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.module.Module;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.proxy.behavior.RasterSearchProxy;
import org.dfra.river.remote.behavior.RemoteBehavior;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * One robot in this virtual machine searches a few lanes while its registrar comes and goes. The
 * short form does so in a {@link SparseField}, beside whose lanes it starts. It leaves to {@code
 * dfra.full} the laser at full rate, the posts, and the way to the lanes.
 */
@Timeout(600)
class EmbeddedMissionIT {

  /** Of the robot's time in a second; so that much slower machines still keep up. */
  private static final double SPEED = 3;

  /** Robot's time; a search of this region takes some 70 s where nothing goes wrong. */
  private static final Duration LONGEST = Duration.ofMinutes(9);

  private static final boolean FULL = Boolean.getBoolean("dfra.full");

  @TempDir Path folder;

  private final RecordingMissionListener reported = new RecordingMissionListener();
  private final RunMeasurements figures = new RunMeasurements();

  /** Looks at the robot and its lookup service while it searches, and does nothing to them. */
  private static final class Onlooker implements InjectedFault<EmbeddedRobot> {

    private final Set<ServiceID> registrars = new HashSet<>();
    private final Map<String, Module> proxies = new TreeMap<>(); // by service ID
    private Set<String> described = Set.of();
    private RasterSearchProxy search;
    private BehaviorStatus fromAfar;
    private boolean wentOnAlone;
    private boolean over;

    @Override
    public void update(FaultInjectionContext<EmbeddedRobot> now) throws IOException {
      var robot = now.robots().get(0);
      Optional<ServiceRegistrar> registrar =
          robot.robot().registrar().registrarIfRunning(); // it is ended meanwhile
      if (registrar.isEmpty()) {
        wentOnAlone |= now.truth().last(robot.name()).speed() > 0.5;
        return;
      }
      if (search == null) {
        search = (RasterSearchProxy) robot.search();
        fromAfar = ((RemoteBehavior<?>) search.server()).status();
        described =
            new HashSet<>(
                robot.robot().description().modules().stream().map(each -> each.path()).toList());
        proxies.putAll(RegistrarContents.query(robot.robot()));
      }
      registrars.add(registrar.get().getServiceID());
      over = registrars.size() > 1;
    }

    @Override
    public boolean hasStarted() {
      return true;
    }

    @Override
    public boolean isOver() {
      return over;
    }
  }

  private Scenario scenario() throws Exception {
    if (FULL) {
      return FewLanes.scenario();
    }
    Path world = SparseField.world(folder, Map.of("atrv1", new Start(10.5, 3, 0)));
    Path robot = SparseField.robot(folder, "atrv1", "drive", Set.of("navigation", "lookup"));
    return FewLanes.scenario(world, robot);
  }

  /** As where the computer does not keep up: what was seen until then is not lost. */
  @Test
  void reportsASearchThatIsGivenUp() throws Exception {
    MissionResult flight =
        new EmbeddedMission(
                scenario(),
                SPEED,
                Duration.ofSeconds(8),
                robot -> robot,
                List.of(new RegistrarOutage(0, 0.9, RegistrarOutage.NEVER)),
                figures)
            .run(reported);
    RobotMissionResult robot = flight.robots().get(0);
    assertThat(robot.completed()).isFalse();
    assertThat(robot.samples()).hasSizeGreaterThan(50);
    assertThat(flight.events()).isEmpty();
    assertThat(figure("injected faults that did not occur, or were not repaired")).isEqualTo(1);
  }

  @Test
  void finishesItsLanesThoughItsRegistrarEndsAndAnotherComesInItsPlace() throws Exception {
    String before = String.valueOf(System.getProperty(RobotTime.PROPERTY));
    Onlooker onlooker = new Onlooker();
    MissionResult flight =
        new EmbeddedMission(
                scenario(),
                SPEED,
                LONGEST,
                robot -> robot,
                List.of(new RegistrarOutage(0, 0.2, 0.6), onlooker),
                figures)
            .run(reported);

    RobotMissionResult robot = flight.robots().get(0);
    String steps = flight.events() + "; " + robot.ending() + "; " + figures.all();
    assertThat(robot.completed()).as(steps).isTrue();
    assertThat(flight.collisions()).as(steps).isEmpty();
    assertThat(flight.events()).as("as reported on the way").isEqualTo(reported.marks());
    String modules = onlooker.described.size() + " modules";
    assertThat(flight.events())
        .extracting(MissionEvent::what)
        .satisfiesExactly(
            what ->
                assertThat(what).startsWith("its registrar is ended, which listed its " + modules),
            what -> assertThat(what).startsWith("its registrar is back and lists its " + modules));
    assertThat(figure("registrar back: modules that are listed under another service ID"))
        .as(steps)
        .isZero();
    assertThat(robot.samples()).hasSizeGreaterThan(300);
    assertThat(robot.readings().advice()).isNotEmpty();

    assertThat(onlooker.wentOnAlone).as("it drove while there was no registrar").isTrue();
    assertThat(onlooker.registrars).as("lookup services, one after the other").hasSize(2);
    assertThat(onlooker.proxies.values()).allMatch(each -> each instanceof ModuleProxy<?>);
    assertThat(
            onlooker.proxies.values().stream()
                .map(each -> ((ModuleProxy<?>) each).identification().path()))
        .as("registered under their own service IDs")
        .containsExactlyInAnyOrderElementsOf(onlooker.described);
    assertThat(onlooker.proxies)
        .allSatisfy((id, each) -> assertThat(((ModuleProxy<?>) each).id()).hasToString(id))
        .containsEntry(onlooker.search.id().toString(), onlooker.search);
    assertThat(onlooker.fromAfar.goal()).as("its exported server, called over TCP").isNotNull();
    assertThat(String.valueOf(System.getProperty(RobotTime.PROPERTY)))
        .as("the time that this virtual machine lives by")
        .isEqualTo(before);
    assertThat(RobotTime.clock()).isSameAs(InstantSource.system());
  }

  private double figure(String what) {
    return figures.all().stream()
        .filter(each -> each.name().equals(what))
        .mapToDouble(MeasuredValue::value)
        .findFirst()
        .orElseThrow(() -> new AssertionError("there is no \"" + what + "\" in " + figures.all()));
  }
}
