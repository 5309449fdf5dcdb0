package org.dfra.examples.persona;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.harness.DemoRunner;
import org.dfra.examples.harness.DemoRunner.Demo;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;

/**
 * The complete distributed layer: two robots publish their capabilities, and a client keeps using
 * them while their processes are killed, suspended, replaced and removed.
 */
public final class PersonaDemo implements Demo {

  private static final int RECEIVERS = 2; // on each robot

  /** The four antennas, and that of the added module; some metres apart. */
  private static final List<GeoPosition> ANTENNAS =
      List.of(
          new GeoPosition(27.950603, -82.457200, 14.5),
          new GeoPosition(27.950597, -82.457200, 14.5),
          new GeoPosition(27.950803, -82.457000, 14.5),
          new GeoPosition(27.950797, -82.457000, 14.5),
          new GeoPosition(27.950800, -82.457000, 15.1));

  private final ProgressReporter progress;

  /** {@code tell} reports the progress. */
  public PersonaDemo(ProgressReporter progress) {
    this.progress = progress;
  }

  @Override
  public boolean run() {
    return DemoRunner.run(progress, this::play);
  }

  private void play(DemoEnvironment environment) throws Exception {
    progress.section("switching on the receivers", "Two robots start");
    List<String> links = environment.startReceivers(ANTENNAS);
    progress.say(
        "%d Motorola M12+ GPS receivers are switched on. They are emulated byte for byte, so that the"
            + " real driver reads them.",
        links.size());
    DemoRobot atrv1 = robot(environment, "atrv1", links.get(0), links.get(1));
    DemoRobot atrv2 = robot(environment, "atrv2", links.get(2), links.get(3));
    List<DemoRobot> robots = List.of(atrv1, atrv2);
    ProgressReporter.Stopwatch coldStart = progress.stopwatch();
    try (ModuleDirectory directory =
        new JiniModuleDirectory(
            DemoEnvironment.ADDRESS, List.of(), robots.stream().map(DemoRobot::locator).toList())) {
      bringUp(robots);
      DiscoveryStep introduction = new DiscoveryStep(progress, directory);
      introduction.awaitRobots(robots.size(), RECEIVERS, coldStart);
      introduction.ask();
      List<FixLog> logs = listen(directory);
      try {
        ReceiverKillStep killed = new ReceiverKillStep(progress, environment, atrv1, directory);
        killed.underASubscription(logs.get(0));
        killed.underACall();
        new ReceiverSuspensionStep(progress, environment, atrv2)
            .play(logs.get(2), List.of(logs.get(0), logs.get(1), logs.get(3)));
        new RegistrarOutageStep(progress, environment, atrv1, directory).play(logs.get(0));
        new ReconfigurationStep(progress, atrv2, directory)
            .play(links.get(4), logs.get(3).module(), logs);
      } finally {
        logs.forEach(FixLog::close);
      }
    }
  }

  private static DemoRobot robot(
      DemoEnvironment environment, String name, String front, String rear) throws IOException {
    return DemoRobot.of(environment, "field", name, Map.of("gps_front", front, "gps_rear", rear));
  }

  /** Both in parallel, as on two computers. */
  private void bringUp(List<DemoRobot> robots) throws Exception {
    progress.step("bringing the robots up");
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    ExecutorService threads = Executors.newFixedThreadPool(robots.size());
    try {
      List<Future<List<RobotBootstrap.ServiceReference>>> begun = new ArrayList<>();
      for (DemoRobot each : robots) {
        begun.add(threads.submit(each::bringUp));
      }
      for (int i = 0; i < robots.size(); i++) {
        List<RobotBootstrap.ServiceReference> services = begun.get(i).get();
        progress.say(
            "Robot %s is up after %s, with its own phoenix: %s, each in its own process.",
            robots.get(i).name(),
            QuantityText.seconds(watch.elapsed()),
            services.stream()
                .map(RobotBootstrap.ServiceReference::name)
                .collect(Collectors.joining(", ")));
      }
    } finally {
      threads.shutdownNow();
    }
    progress.say(
        "Phoenix is the daemon that starts a robot's processes and restarts them. The registrar is"
            + " the robot's own lookup service: its modules publish their capabilities there.");
  }

  private List<FixLog> listen(ModuleDirectory directory) throws Exception {
    progress.section("listening to the receivers", "The client subscribes to all four");
    List<FixLog> logs = new ArrayList<>();
    for (var each : directory.find(ModuleQuery.of(GPSSensor.class))) {
      logs.add(FixLog.of(each));
    }
    for (FixLog each : logs) {
      FixLog.Arrival first = each.next(DemoEnvironment.PATIENCE);
      progress.say("Reading no. %d of %s has arrived.", first.number(), each.path());
    }
    return logs;
  }
}
