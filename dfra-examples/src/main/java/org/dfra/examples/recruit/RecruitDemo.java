package org.dfra.examples.recruit;

import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.core.time.RobotTime;
import org.dfra.core.time.ScaledTime;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRunner;
import org.dfra.examples.harness.DemoRunner.Demo;
import org.dfra.examples.mission.monitor.AnnouncedTime;
import org.dfra.geometry.LocalFrame;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.PortPolicy;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.file.WorldXml;

/**
 * A UAV flies over targets that need inspection from near and calls for help, and ground robots
 * come by their own behaviours: one stays and is released, one dies on its way and is replaced, and
 * one loses contact with an unreachable requester and frees itself.
 */
public final class RecruitDemo implements Demo {

  private static final double SPEED = 2;
  private static final double FASTEST = 5;
  private static final double SLOWEST = 0.5;
  private static final Path WORLD =
      Path.of(System.getProperty("dfra.root", "."), "config", "worlds", "recruit.xml");

  private final ProgressReporter progress;
  private final double speed;
  private final Path report;

  private RecruitDemo(ProgressReporter progress, double speed, Path report) {
    this.progress = progress;
    this.speed = speed;
    this.report = report;
  }

  /**
   * The demonstration; starts nothing.
   *
   * @param speed seconds of the robots' time per second, {@value #SLOWEST} to {@value #FASTEST};
   *     empty for {@value #SPEED}
   * @param report the folder of its report
   * @throws CommandFailure if the speed is out of range
   */
  public static RecruitDemo of(ProgressReporter progress, Optional<Double> speed, Path report) {
    double wanted = speed.orElse(SPEED);
    if (!(wanted >= SLOWEST && wanted <= FASTEST)) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR,
          String.format(
              Locale.ROOT,
              "--speed %s is outside %s to %s, the range in which agents in processes keep up",
              wanted,
              SLOWEST,
              FASTEST));
    }
    return new RecruitDemo(progress, wanted, report);
  }

  @Override
  public boolean run() {
    return DemoRunner.run(progress, this::play);
  }

  private void play(DemoEnvironment environment) throws Exception {
    try (AnnouncedTime time = new AnnouncedTime()) {
      Instant began = Instant.now().truncatedTo(ChronoUnit.MILLIS);
      time.set(speed == 1 ? RobotTime.REAL : new ScaledTime(speed, began).toHostText());
      InstantSource clock = RobotTime.clock();
      WorldDescription world = WorldXml.read(WORLD);
      List<String> names = world.vehicles().stream().map(each -> each.name()).toList();
      progress.section("starting the robots", "The team");
      progress.say(
          "Five robots in a simulated world. Each robot's modules except its agent are embedded in"
              + " this virtual machine: registrar, drivers that read the bytes of emulated devices"
              + " over TCP, schemas and behaviours, exported and found through lookup. Each robot's"
              + " agent is an activated module in a service group, a process, of its own; one"
              + " phoenix serves all five. At the left is real time; \"after 30 s\" is the robots'"
              + " time, which passes %s times as fast.",
          speed);
      try (Simulation simulation = Simulation.overTcp(world, clock, PortPolicy.EPHEMERAL)) {
        simulation.start();
        LocalFrame frame = new LocalFrame(world.datum());
        try (DemoTeam team = new DemoTeam(environment, simulation, names);
            JiniModuleDirectory directory =
                new JiniModuleDirectory(DemoEnvironment.ADDRESS, List.of(), team.locators());
            TrueTrajectories ways =
                new TrueTrajectories(names, simulation.world().groundTruth(), clock);
            AgentMonitor monitor = AgentMonitor.start(directory, progress, began);
            BackgroundSearches searches =
                new BackgroundSearches(progress, directory, frame, BackgroundSearches.PATIENCE)) {
          ways.start();
          try (LiveView live =
              new LiveView(
                  progress, names, began, clock, frame, directory, monitor, searches, ways)) {
            live.start();
            team.start();
            RecruitScenario scenario =
                new RecruitScenario(
                    progress,
                    team,
                    directory,
                    monitor,
                    searches,
                    simulation.world(),
                    ways,
                    frame,
                    clock);
            scenario.play();
          }
          progress.section("writing the report", "The report");
          DemoTimeline timeline = new DemoTimeline(began, frame, monitor, ways);
          RecruitCharts figures = new RecruitCharts(names, world, timeline);
          Path file = new RecruitReport(timeline, figures, speed, progress.figures()).write(report);
          progress.say(
              "A map of their paths, a chart of each conversation, and shame over time are in"
                  + " %s.",
              file);
        }
      }
    }
  }
}
