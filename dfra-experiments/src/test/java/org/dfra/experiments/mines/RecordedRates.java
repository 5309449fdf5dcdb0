package org.dfra.experiments.mines;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What the last run of {@code ./dfra bench mines} wrote down. */
final class RecordedRates {

  private static final Path FILE =
      Path.of(System.getProperty("dfra.root"), "benchmarks", "mines.csv");

  /** When, bench, java, cores, load, figure in quotation marks, measured, the rest. */
  private static final Pattern ROW =
      Pattern.compile("[^,]*,mines,[^,]*,[^,]*,[^,]*,\"([^\"]*)\",([^,]*),.*");

  private RecordedRates() {}

  /** Each figure as it was last measured, by its name. */
  static Map<String, Double> last() throws IOException {
    Map<String, Double> figures = new HashMap<>();
    for (String line : Files.readAllLines(FILE)) {
      Matcher row = ROW.matcher(line);
      if (row.matches()) {
        figures.put(row.group(1), Double.valueOf(row.group(2)));
      }
    }
    return figures;
  }
}
