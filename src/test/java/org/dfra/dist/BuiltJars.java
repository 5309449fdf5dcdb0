package org.dfra.dist;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The jars that this build has made for a robot, by Maven or by Gradle.
 *
 * @param lib folder of those on the class path
 * @param boot what stands in front of Java's own classes
 */
public record BuiltJars(Path lib, Path boot) {

  /** The jars. The test reports itself skipped where nothing is packaged yet. */
  public static BuiltJars assumed() {
    Path root = Path.of(System.getProperty("dfra.root"));
    String build = Files.isDirectory(root.resolve("dfra-cli/target/lib")) ? "target" : "build";
    Path lib = root.resolve("dfra-cli").resolve(build).resolve("lib");
    assumeTrue(Files.isDirectory(lib), "nothing is packaged yet: run a whole build");
    Path boot =
        root.resolve("dfra-activation")
            .resolve(build.equals("target") ? build : "build/libs")
            .resolve("dfra-activation.jar");
    return new BuiltJars(lib, boot);
  }
}
