package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.loading.RobotCodebase;
import org.jspecify.annotations.Nullable;

/** The jars for clients that lack a robot's classes. */
final class DownloadJars {

  /** System property with the folder of DFRA's jars; {@code ./dfra} sets it. */
  static final String LIB = "dfra.lib";

  private DownloadJars() {}

  /**
   * The jars that a robot serves: DFRA's own download jars, if {@code dfra.lib} is set, and those
   * of its modules.
   *
   * @param state phoenix's folder
   * @return empty if it runs no class server or there is nothing to serve
   * @throws IOException if DFRA's own jars are missing
   */
  static Optional<RobotCodebase> of(RobotDescription robot, String host, Path state)
      throws IOException {
    Optional<RegistrarDescription> registrar =
        robot.registrar().filter(RegistrarDescription::hasClassServer);
    if (registrar.isEmpty()) {
      return Optional.empty();
    }
    Path kept = state.toAbsolutePath().resolve("classes").resolve(robot.name());
    List<List<Path>> kinds = new ArrayList<>();
    robot.modules().forEach(each -> kinds.add(each.codebase().stream().map(Path::of).toList()));
    return Optional.of(
            new RobotCodebase(host, registrar.get().classServerPort(), kept, kinds, ofDfra()))
        .filter(classes -> !classes.isEmpty());
  }

  /**
   * The jars in DFRA's own folder {@code dl}, sorted by name; none if DFRA is a part of another
   * program, which has no such folder.
   *
   * @throws IOException if they are missing
   */
  private static List<Path> ofDfra() throws IOException {
    return listJars(System.getProperty(LIB));
  }

  static List<Path> listJars(@Nullable String lib) throws IOException {
    if (lib == null) {
      return List.of();
    }
    Path folder = Path.of(lib).toAbsolutePath().resolve("dl");
    List<Path> jars = List.of();
    if (Files.isDirectory(folder)) {
      try (Stream<Path> files = Files.list(folder)) {
        jars = files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
      }
    }
    if (jars.isEmpty()) {
      throw new IOException(
          "there is no jar for clients to download in "
              + folder
              + "; rebuild DFRA, or write class-server-port=\"off\" in <registrar>");
    }
    return jars;
  }
}
