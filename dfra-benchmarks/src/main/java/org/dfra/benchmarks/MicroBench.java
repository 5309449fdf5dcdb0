package org.dfra.benchmarks;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dfra.benchmarks.MicroTask.MicroSettings;
import org.dfra.benchmarks.micro.MicroBenchmark;
import org.dfra.benchmarks.micro.MicroResults;
import org.dfra.benchmarks.task.TaskProcess;

/**
 * Measures single operations by JMH: the distribution of an operation's time, in virtual machines
 * with the options of robots, and the ratio to the same operation of plain Java where there is one.
 */
final class MicroBench implements Bench {

  private static final Duration PATIENCE = Duration.ofMinutes(3); // for one benchmark
  private static final String HEAP = "-Xmx256m";
  private static final int COLUMNS = 110;

  private final List<MicroBenchmark> chosen;
  private final MicroSettings settings;

  MicroBench(List<MicroBenchmark> chosen, MicroSettings settings) {
    this.chosen = chosen;
    this.settings = settings;
  }

  @Override
  public void run(Report report) throws Exception {
    report.say(
        chosen.size()
            + (chosen.size() == 1 ? " benchmark, " : " benchmarks, ")
            + settings.rounds()
            + (settings.rounds() == 1 ? " round" : " rounds")
            + "; each runs in a JVM of its own with the options of robots, "
            + settings.warmUpMillis() / 1e3
            + " s to warm up and "
            + settings.measuredMillis() / 1e3
            + " s measured.");
    if (settings.equals(MicroSettings.QUICK)) {
      report.say("This is a short run: it shows that all benchmarks run, not how fast.");
    }
    MicroResults results = new MicroResults(chosen);
    try (TaskProcess process =
        TaskProcess.start(
            List.of(),
            List.of(HEAP, "-Ddfra.root=" + root()),
            MicroTask.class,
            MicroTask.arguments(settings, chosen))) {
      follow(process, report, results);
    }
    report.say("");
    results.table().lines(COLUMNS).forEach(report::say);
    results.figures().forEach(report.figures()::add);
  }

  private static Path root() {
    return Path.of(System.getProperty("dfra.root", ".")).toAbsolutePath();
  }

  private void follow(TaskProcess process, Report report, MicroResults results)
      throws IOException, InterruptedException {
    String shown = "";
    while (true) {
      String[] words = process.awaitLine("", PATIENCE).split(" ", -1);
      switch (words[0]) {
        case "round" -> {
          String group =
              "Round " + words[1] + " of " + settings.rounds() + ": " + subject(words[2]);
          if (!group.equals(shown)) {
            report.say(group + " …");
          }
          shown = group;
        }
        case "result" ->
            results.add(words[1], Double.parseDouble(words[2]), Double.parseDouble(words[3]));
        case "done" -> {
          return;
        }
        default -> throw new IOException("the benchmarks " + String.join(" ", words));
      }
    }
  }

  private String subject(String id) {
    return chosen.stream()
        .filter(each -> each.id().equals(id))
        .map(MicroBenchmark::subject)
        .findFirst()
        .orElse(id);
  }
}
