package org.dfra.app.measurement;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Where a command's figures are kept. A picocli mix-in. */
public final class RecordOption {

  @Option(
      names = "--record",
      paramLabel = "FILE",
      description = "Append the measured figures to this CSV file.")
  private @Nullable Path file;

  /**
   * Appends the figures to the file, if one was named.
   *
   * @param kind what is measured by, {@code demo} or {@code bench}
   * @param name which one of these
   */
  public void append(RunMeasurements figures, String kind, String name) throws IOException {
    if (file != null) {
      figures.append(file, kind, name);
    }
  }
}
