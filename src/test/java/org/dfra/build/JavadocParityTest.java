package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Maven and Gradle build the same API documentation. */
class JavadocParityTest {

  /** Maven names the skipped modules by artifactId; in Gradle, src/test is no subproject. */
  @Test
  void bothBuildsDocumentTheSameModules() {
    Map<String, String> maven = javadocOfMaven();
    Set<String> skipped = new TreeSet<>(List.of(maven.get("skippedModules").split(",")));
    assertThat(skipped.remove("dfra-integration-tests")).isTrue();
    assertThat(maven).containsEntry("excludePackageNames", "java.rmi.activation");
    assertThat(gradleScript()).contains("exclude(\"java/rmi/activation/**\")");
    Matcher gradle =
        Pattern.compile("val undocumented = setOf\\(\"(.*)\"\\)").matcher(gradleScript());
    assertThat(gradle.find()).as("val undocumented = setOf(...) in build.gradle.kts").isTrue();
    assertThat(List.of(gradle.group(1).split("\", \""))).containsExactlyElementsOf(skipped);
    assertThat(new MavenBuild(Repository.root()).model().modules().keySet()).containsAll(skipped);
  }

  @Test
  void bothBuildsGiveJavadocTheSameOptions() {
    Map<String, String> maven = javadocOfMaven();
    assertThat(maven)
        .as("one that is new here has to be compared below")
        .containsOnlyKeys(
            Stream.of(
                    "skippedModules, excludePackageNames, sourceFileExcludes, quiet",
                    "outputDirectory, staleDataPath",
                    "doclint, failOnWarnings, locale, notimestamp, windowtitle, doctitle, bottom",
                    "use, version, author, detectJavaApiLink, detectLinks, detectOfflineLinks")
                .flatMap(each -> Stream.of(each.split(", ")))
                .toList())
        .containsEntry("outputDirectory", "${project.build.directory}")
        .containsEntry("failOnWarnings", "true")
        .containsEntry("notimestamp", "true");
    for (String name :
        List.of(
            "use", "version", "author", "detectJavaApiLink", "detectLinks", "detectOfflineLinks")) {
      assertThat(maven)
          .as("Gradle's Javadoc does not do it by itself")
          .containsEntry(name, "false");
    }
    Matcher gradle =
        Pattern.compile(
                "(?s)\\(options as StandardJavadocDocletOptions\\)\\.apply \\{\\n(.*?)\\n    \\}")
            .matcher(gradleScript());
    assertThat(gradle.find()).as("the options of tasks.javadoc in build.gradle.kts").isTrue();
    assertThat(gradle.group(1).lines().map(String::strip))
        .containsExactlyInAnyOrder(
            "encoding = \"UTF-8\"",
            "addStringOption(\"-release\", \"17\")",
            "addBooleanOption(\"Xdoclint:" + maven.get("doclint") + "\", true)",
            "addBooleanOption(\"Xwerror\", true)",
            "locale = \"" + maven.get("locale") + "\"",
            "isNoTimestamp = true",
            "windowTitle = \"" + maven.get("windowtitle") + "\"",
            "docTitle = \"" + maven.get("doctitle") + "\"",
            "bottom = \"" + maven.get("bottom") + "\"");
    assertThat(gradleScript()).contains("setDestinationDir(layout.buildDirectory.dir(\"apidocs\")");
    assertThat(Repository.read(Repository.root().resolve("pom.xml")))
        .contains(
            "<maven.compiler.release>17</maven.compiler.release>",
            "<project.build.sourceEncoding>UTF-8</project.build.sourceEncoding>");
  }

  /** So that a comment that Javadoc refuses is refused by every build, not only by this verb. */
  @Test
  void bothCompilersCheckCommentsAsJavadocDoes() {
    String doclint = "-Xdoclint:" + javadocOfMaven().get("doclint");
    assertThat(Repository.read(Repository.root().resolve("pom.xml")))
        .containsOnlyOnce("<arg>" + doclint + "</arg>");
    assertThat(gradleScript())
        .contains(
            "tasks.named<JavaCompile>(\"compileJava\") { options.compilerArgs.add(\""
                + doclint
                + "\") }");
  }

  /**
   * Javadoc refuses a second description of a package. The daemon's module describes phoenix:
   * Gradle leaves out the other file; Maven leaves out both, and Javadoc finds the first one by
   * itself.
   */
  @Test
  void bothBuildsShowTheSameDescriptionOfAPackageThatTwoModulesShare() {
    Path root = Repository.root();
    Map<Path, List<Path>> descriptions =
        Repository.mainPackages(root).stream()
            .map(directory -> root.relativize(directory).resolve("package-info.java"))
            .collect(Collectors.groupingBy(file -> file.subpath(4, file.getNameCount())));
    descriptions.values().removeIf(files -> files.size() < 2);
    Path shared = Path.of("org/dfra/river/phoenix/package-info.java");
    assertThat(descriptions).containsOnlyKeys(shared);
    Path download = Path.of("dfra-client/src/main/java").resolve(shared);
    assertThat(descriptions.get(shared))
        .containsExactlyInAnyOrder(download, Path.of("dfra-phoenix/src/main/java").resolve(shared));
    assertThat(gradleScript())
        .contains("val download = file(\"" + download + "\")", "exclude { it.file == download }");
    assertThat(javadocOfMaven()).containsEntry("sourceFileExcludes", shared.toString());
    assertThat(new MavenBuild(root).model().modules().keySet())
        .containsSubsequence("dfra-phoenix", "dfra-client");
  }

  private static Map<String, String> javadocOfMaven() {
    return new MavenBuild(Repository.root()).configuration("maven-javadoc-plugin");
  }

  private static String gradleScript() {
    return GradleBuild.withoutComments(
        Repository.read(Repository.root().resolve("build.gradle.kts")));
  }
}
