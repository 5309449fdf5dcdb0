package org.dfra.examples.raster;

import java.nio.file.Path;
import java.util.Optional;
import org.dfra.cli.task.LaneSettings;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The command-line options of a search by raster. A picocli mix-in. */
public final class RasterOptions {

  @Option(
      names = "--local",
      description =
          "Raster: run all in one virtual machine, in lock-step, at the computer's full speed; the same"
              + " seed gives the same search.")
  boolean local;

  @Option(
      names = "--embedded",
      description =
          "Raster: run all in one virtual machine, with real lookup services and devices over TCP;"
              + " ends lookup services during the run, kills no process.")
  boolean embedded;

  @Option(
      names = "--region",
      paramLabel = "REGION",
      description =
          "Raster: region to search: a GeoJSON file, or corners as in \"48.0001,11.0001"
              + " 48.0001,11.0004 48.0002,11.0004\" (default: the world's own; in processes the"
              + " middle of it).")
  @Nullable String region;

  @Option(
      names = "--speed",
      paramLabel = "N",
      description =
          "Raster, recruit: simulated seconds per second, 0.01 to 1000, for recruit 0.5 to 5"
              + " (default "
              + SimulationSpeed.DEFAULT_IN_ONE_JVM
              + "; raster in processes: "
              + SimulationSpeed.IN_PROCESSES
              + ", or less if the computer does not keep up; recruit: 2).")
  @Nullable Double speed;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "Raster: random seed, instead of the world's own seed.")
  @Nullable Long seed;

  @Option(
      names = "--swath",
      paramLabel = "M",
      description =
          "Raster: width of the strip that a robot sees, in metres (default "
              + LaneSettings.SWATH
              + ").")
  @Nullable Double swath;

  @Option(
      names = "--spacing",
      paramLabel = "M",
      description =
          "Raster: distance between lanes, in metres, at most the swath (default: "
              + LaneSettings.SPACING_FRACTION
              + " of it).")
  @Nullable Double spacing;

  @Option(
      names = "--world",
      paramLabel = "FILE",
      description = "Raster: the world's XML (default config/worlds/raster.xml).")
  @Nullable Path world;

  /** Seconds of the robots' clock per second; empty if not given. */
  public Optional<Double> speed() {
    return Optional.ofNullable(speed);
  }
}
