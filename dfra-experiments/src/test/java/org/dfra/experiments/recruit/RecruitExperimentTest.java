package org.dfra.experiments.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dfra.cli.Main;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.requester.Bid;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.report.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** {@code ./dfra recruit experiment}, with a few runs of each cell. */
@Timeout(300)
class RecruitExperimentTest {

  /** Verdict, date and targets are the first of a report. */
  private static final String REPORT_HEAD =
      "</h1>\\s*<p class=\"verdict (met|missed)\">[^<]+</p>"
          + "\\s*<p>[-\\d]+ [:\\d]+\\sUTC</p>\\s*<table>";

  /** A user's strategy: robots that are not busy answer. */
  public static final class Modest implements RecruitmentStrategy {
    @Override
    public String name() {
      return "modest";
    }

    @Override
    public boolean shouldOffer(Stimulus stimulus) {
      return !stimulus.busy();
    }

    @Override
    public Bid choose(List<Bid> bids) {
      return RecruitmentStrategy.nearest(bids);
    }
  }

  @TempDir Path folder;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int experiment(String... arguments) {
    CommandLine line = Main.commandLine();
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    return line.execute(
        Stream.concat(Stream.of("recruit", "experiment"), Stream.of(arguments))
            .toArray(String[]::new));
  }

  private static String read(Path file) throws IOException {
    return Files.readString(file);
  }

  @Test
  void writesAReportWithEveryRunAndIsTheSameEachTime() throws Exception {
    Path one = folder.resolve("one");
    int ended = experiment("--seeds=2", "--jobs=2", "--report=" + one);
    assertThat(ended).isEqualTo(out.toString().contains("MISSED") ? 1 : 0);
    assertThat(err.toString()).isEmpty();
    assertThat(read(one.resolve("runs.csv")).lines()).hasSize(1 + 96 * 2);
    assertThat(read(one.resolve("cells.csv")).lines()).hasSize(1 + 96 * 10);
    assertThat(read(one.resolve("claims.csv")).lines()).hasSize(1 + 24 * 3 * 10);
    assertThat(read(one.resolve("report.html"))).containsPattern(REPORT_HEAD);
    assertThat(read(one.resolve("report.html")))
        .contains(
            "<svg", "class=\"verdict", "Target", "Losses", "no published number is reproduced")
        .contains("message-delays-v1.csv");
    try (Stream<Path> files = Files.list(one)) {
      List<Path> pictures = files.filter(each -> each.toString().endsWith(".svg")).toList();
      assertThat(pictures).hasSize(11);
      for (Path each : pictures) {
        String text =
            DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(each.toFile())
                .getDocumentElement()
                .getTextContent();
        assertThat(text).contains("broadcast, 3 vehicles", "unicast, 12 vehicles", "contract-net");
        assertThat(text).as("%s: text that was cut", each).doesNotContain("…");
      }
    }

    Path again = folder.resolve("again");
    experiment("--seeds=2", "--jobs=1", "--report=" + again);
    for (String each : List.of("runs.csv", "cells.csv", "claims.csv")) {
      assertThat(again.resolve(each)).hasSameTextualContentAs(one.resolve(each));
    }
  }

  @Test
  void runsAUsersStrategyBesideTheFourWithLossesInBurstsAndDelaysOfAFile() throws Exception {
    Path delays = Files.writeString(folder.resolve("slow.csv"), "delay_ms\n5\n250\n");
    String name = Modest.class.getName();
    experiment(
        "--seeds=2", "--strategy", name, "--burst=4", "--delays=" + delays, "--report=" + folder);
    assertThat(err.toString()).isEmpty();
    assertThat(read(folder.resolve("runs.csv")).lines().filter(each -> each.startsWith(name)))
        .hasSize(2 * 24);
    assertThat(read(folder.resolve("report.html"))).contains(name, "in bursts of 4", "slow.csv");
    assertThat(out.toString().replaceAll("\\s+", " "))
        .contains("fewer transmissions than " + name + " in ");
  }

  /**
   * A few runs of each cell: that it works, and says what it found. Teams for 60 runs at once, as
   * usual, would take most of the time to start.
   */
  @Test
  void runsOverRealRemoteEventsAndComparesThemWithTheSimulation() throws Exception {
    int ended =
        experiment("--embedded", "--seeds=2", "--jobs=8", "--speed=200", "--report=" + folder);
    assertThat(err.toString()).isEmpty();
    assertThat(ended).isEqualTo(out.toString().contains("MISSED") ? 1 : 0);
    String reported = out.toString().replaceAll("\\s+", " ");
    // How many is not held here: on a busy computer two seconds of their time are nothing.
    assertThat(reported)
        .containsPattern("second helpers over JERI \\d")
        .contains("orphaned helpers");
    assertThat(read(folder.resolve("runs-real.csv")).lines()).hasSize(1 + 16 * 2);
    assertThat(read(folder.resolve("runs-simulated.csv")).lines()).hasSize(1 + 16 * 20);
    assertThat(read(folder.resolve("transport-comparison.csv")).lines()).hasSize(1 + 16 * 4);
    assertThat(read(folder.resolve("message-delays.csv")).lines().count())
        .as("each of 96 calls takes several messages")
        .isGreaterThan(96 * 4);
    String report = read(folder.resolve("report.html"));
    assertThat(report).containsPattern(REPORT_HEAD);
    assertThat(report)
        .contains("second helpers over JERI", "comparisons that differ</td>")
        .contains("Simulated and real transport", "Kolmogorov-Smirnov", "Holm", "<svg");
    assertThat(out.toString().replaceAll("\\s+", " ")).contains("Of 64 comparisons ");
  }

  private void refused(int exit, String sentence, String... arguments) {
    assertThat(experiment(arguments)).as("%s", err).isEqualTo(exit);
    assertThat(err.toString().strip()).isEqualTo("dfra: " + sentence);
    assertThat(out.toString()).isEmpty();
    err.getBuffer().setLength(0);
  }

  @Test
  void refusesInOneSentenceWhatCannotBe() throws Exception {
    String report = "--report=" + folder.resolve("report");
    refused(
        ExitCode.USAGE_ERROR,
        "--seeds=0 is not a number from 2 to 10000; see: ./dfra recruit experiment --help",
        "--seeds=0",
        report);
    refused(
        ExitCode.USAGE_ERROR,
        "--jobs=0 is not a number from 1 to 256; see: ./dfra recruit experiment --help",
        "--jobs=0",
        report);
    refused(
        ExitCode.USAGE_ERROR,
        "--burst=0.5 is not a number from 1 to 100; see: ./dfra recruit experiment --help",
        "--burst=0.5",
        report);
    refused(
        ExitCode.FAILED,
        "unknown strategy \"gredy\"; did you mean \"greedy\"?",
        "--strategy=gredy",
        report);
    refused(
        ExitCode.FAILED,
        "strategy class org.example.Nobody is not on the class path; add its jar or correct the"
            + " name",
        "--strategy=org.example.Nobody",
        report);
    refused(
        ExitCode.USAGE_ERROR,
        "--speed=0.0 is not a number from 1 to 1000; see: ./dfra recruit experiment --help",
        "--embedded",
        "--speed=0",
        report);
    refused(
        ExitCode.USAGE_ERROR,
        "--speed requires --embedded; simulated runs do not use real time; see: ./dfra recruit"
            + " experiment --help",
        "--speed=10",
        report);
    refused(
        ExitCode.USAGE_ERROR,
        "--embedded compares two strategies of DFRA with measured delays; omit --strategy and"
            + " --delays; see: ./dfra recruit experiment --help",
        "--embedded",
        "--strategy=random",
        report);
    Path columns = Files.writeString(folder.resolve("columns.csv"), "delay_s\n1\n");
    refused(
        ExitCode.FAILED,
        columns + ": the first line has no column delay_ms",
        "--delays=" + columns,
        report);
    assertThat(folder.resolve("report")).doesNotExist();
  }

  @Test
  void refusesAFolderThatCannotBeWritten() throws Exception {
    Path file = Files.writeString(folder.resolve("file"), "in the way");
    assertThat(experiment("--seeds=2", "--report=" + file.resolve("report")))
        .isEqualTo(ExitCode.FAILED);
    assertThat(err.toString().strip().lines()).hasSize(1);
    assertThat(err.toString())
        .startsWith("dfra: the folder --report " + file.resolve("report") + " cannot be written to")
        .contains("name another");
    assertThat(out.toString()).isEmpty();
  }
}
