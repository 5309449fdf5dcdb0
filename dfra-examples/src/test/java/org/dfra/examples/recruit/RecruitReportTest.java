package org.dfra.examples.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleDirectory;
import org.dfra.geometry.LocalFrame;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.sim.world.World;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.file.WorldXml;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The report of a demonstration in which nobody called for help yet. */
class RecruitReportTest {

  /** Verdict, date and targets are the first of a report. */
  private static final String REPORT_HEAD =
      "</h1>\\s*<p class=\"verdict (met|missed)\">[^<]+</p>"
          + "\\s*<p>[-\\d]+ [:\\d]+\\sUTC</p>\\s*<table>";

  private static final Path WORLD =
      Path.of(System.getProperty("dfra.root"), "config", "worlds", "recruit.xml");
  private static final Instant BEGIN = Instant.parse("2026-11-22T00:00:00Z");

  @TempDir Path folder;

  @Test
  void verdictDateAndTargetsStandFirst() throws Exception {
    WorldDescription world = WorldXml.read(WORLD, name -> null);
    List<String> names = world.vehicles().stream().map(each -> each.name()).toList();
    DirectoryRegistration registration = () -> {};
    ModuleDirectory directory =
        (ModuleDirectory)
            Proxy.newProxyInstance(
                getClass().getClassLoader(),
                new Class<?>[] {ModuleDirectory.class},
                (self, method, arguments) -> registration); // it is only listened to
    RunMeasurements measured = new RunMeasurements();
    measured.add(new MeasuredValue("seconds in which two helped", 0, 0, "s"));
    try (TrueTrajectories ways =
            new TrueTrajectories(names, World.of(world, BEGIN).groundTruth(), () -> BEGIN);
        AgentMonitor monitor =
            AgentMonitor.start(
                directory,
                new ProgressReporter(new PrintWriter(new StringWriter()), () -> 0),
                BEGIN)) {
      ways.start();
      DemoTimeline timeline = new DemoTimeline(BEGIN, new LocalFrame(world.datum()), monitor, ways);
      Path file =
          new RecruitReport(timeline, new RecruitCharts(names, world, timeline), 2, measured)
              .write(folder);
      String html = Files.readString(file);
      assertThat(html).containsPattern(REPORT_HEAD);
      assertThat(html).contains("<td>seconds in which two helped</td>", "Paths");
    }
  }
}
