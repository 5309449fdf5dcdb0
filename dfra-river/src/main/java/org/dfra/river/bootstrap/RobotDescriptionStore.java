package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.PrivateFiles;

/**
 * The last descriptions of the robots of a host, each as XML with all variables substituted, beside
 * phoenix's journal. So other commands find them, even if the original XML no longer exists.
 */
public final class RobotDescriptionStore {

  private static final String XML = ".xml";

  private final Path folder;

  /**
   * @param state phoenix's state folder
   */
  public RobotDescriptionStore(Path state) {
    this.folder = state.resolve("robots");
  }

  /** Stores a robot's description and replaces the one of the same name. */
  public void save(RobotDescription robot) throws IOException {
    PrivateFiles.makeFolder(folder);
    Path draft = Files.createTempFile(folder, robot.name(), ".draft");
    try {
      RobotXml.write(robot, draft);
      Files.move(draft, file(robot.name()), StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(draft);
    }
  }

  /** The stored description of a robot. */
  public Optional<RobotDescription> find(String robot) {
    Path file = file(robot);
    return Files.exists(file) ? Optional.of(RobotXml.read(file)) : Optional.empty();
  }

  /** Whether a robot's description is stored. */
  public boolean contains(String robot) {
    return Files.exists(file(robot));
  }

  /** Deletes every description. */
  public void deleteAll() throws IOException {
    if (Files.isDirectory(folder)) {
      try (Stream<Path> files = Files.list(folder)) {
        for (Path file : files.filter(each -> each.toString().endsWith(XML)).toList()) {
          Files.deleteIfExists(file);
        }
      }
    }
  }

  /** All robots, in alphabetical order. */
  public List<RobotDescription> all() throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    List<RobotDescription> robots = new ArrayList<>();
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.filter(each -> each.toString().endsWith(XML)).sorted().toList()) {
        robots.add(RobotXml.read(file));
      }
    }
    return robots;
  }

  /** Deletes a robot's description; does nothing if it is not stored. */
  public void delete(String robot) throws IOException {
    Files.deleteIfExists(file(robot));
  }

  private Path file(String robot) {
    return folder.resolve(robot + XML);
  }
}
