package org.dfra.report.measurement;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The file to which a command's measurements are appended. A picocli mix-in. */
public final class RecordOption {

  @Option(
      names = "--record",
      paramLabel = "FILE",
      description = "Append the measured figures to this CSV file.")
  private @Nullable Path file;

  /**
   * Appends the measurements to the file, if one was named.
   *
   * @param kind of the measuring program, {@code demo} or {@code bench}
   * @param name of this demonstration or benchmark
   */
  public void append(RunMeasurements figures, String kind, String name) throws IOException {
    if (file != null) {
      figures.append(file, kind, name);
    }
  }
}
