package org.dfra.report.measurement;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The measurements of one run. Confined to the thread that runs it. */
public final class RunMeasurements {

  private final List<MeasuredValue> all = new ArrayList<>();

  /** Adds one. */
  public void add(MeasuredValue figure) {
    all.add(figure);
  }

  /** All, in the order added. */
  public List<MeasuredValue> all() {
    return List.copyOf(all);
  }

  /** Those that miss their targets. */
  public List<MeasuredValue> missed() {
    return all.stream().filter(each -> !each.isMet()).toList();
  }

  /** Requirements that are not met. */
  public List<MeasuredValue> failedRequirements() {
    return missed().stream().filter(each -> !each.isTime()).toList();
  }

  /** Times that exceed their targets. */
  public List<MeasuredValue> missedTimes() {
    return missed().stream().filter(MeasuredValue::isTime).toList();
  }

  /** Whether any time has a target. */
  public boolean hasTimes() {
    return all.stream().anyMatch(each -> each.isTime() && each.hasTarget());
  }

  /**
   * Appends them to a CSV file, which is created with a header if it does not exist; with the
   * machine's load average of the last minute, since load affects times.
   *
   * @param kind of the measuring program, as in its column: {@code demo}, {@code bench} or {@code
   *     soak}
   * @param name of this demonstration, benchmark or test
   */
  public void append(Path file, String kind, String name) throws IOException {
    StringBuilder rows = new StringBuilder();
    if (!Files.exists(file)) {
      rows.append("when,").append(kind);
      rows.append(",java,cores,load,figure,measured,target_max,unit\n");
    }
    double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    Instant now = Instant.now().truncatedTo(ChronoUnit.SECONDS);
    for (MeasuredValue each : all) {
      rows.append(
          String.format(
              Locale.ROOT,
              "%s,%s,%s,%d,%.1f,\"%s\",%s,%s,%s%n",
              now,
              name,
              Runtime.version().feature(),
              Runtime.getRuntime().availableProcessors(),
              load,
              each.name(),
              MeasuredValue.csvNumber(each.value()),
              each.hasTarget() ? MeasuredValue.csvNumber(each.target()) : "",
              each.unit()));
    }
    Files.writeString(file, rows, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
  }
}
