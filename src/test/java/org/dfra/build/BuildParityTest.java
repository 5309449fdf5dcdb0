package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dfra.build.BuildModel.Dependency;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Maven and Gradle build the same house: the same modules, needing the same in the same versions
 * and scopes.
 */
class BuildParityTest {

  /**
   * Surefire finds the launcher itself, Gradle wants it named (and takes its version from JUnit's
   * own constraints).
   */
  private static final Dependency GRADLE_ONLY =
      new Dependency("org.junit.platform:junit-platform-launcher", "no managed version", "test");

  @TempDir Path elsewhere;

  @Test
  void bothBuildsHaveTheSameModulesAndDependencies() {
    assertThat(differences(Repository.root())).isEmpty();
  }

  @Test
  void readsSomethingAtAll() {
    MavenBuild maven = new MavenBuild(Repository.root());
    assertThat(maven.model().modules()).containsKeys("dfra-activation", "dfra-river", "src/test");
    assertThat(maven.model().modules().get("dfra-river"))
        .contains(
            new Dependency(
                "net.jini:jsk-platform",
                maven.managedVersions().get("net.jini:jsk-platform"),
                "compile"),
            new Dependency(
                "org.dfra:dfra-activation",
                maven.managedVersions().get("org.dfra:dfra-core"),
                "provided"));
  }

  @Test
  void versionsAreWrittenOnlyInTheRootPom() {
    assertThat(new MavenBuild(Repository.root()).managedWithoutProperty()).isEmpty();
    for (Path script : gradleScripts()) {
      assertThat(GradleBuild.withoutComments(Repository.read(script)))
          .as("%s: a version is written in pom.xml, nowhere else", script)
          .doesNotContainPattern("\\d+\\.\\d+");
    }
  }

  @Test
  void gradleTakesItsModulesFromThePomAndOnlyCorePlugins() {
    assertThat(Repository.read(Repository.root().resolve("settings.gradle.kts")))
        .as("settings.gradle.kts reads the modules from pom.xml and names none")
        .doesNotContainPattern("\"dfra-\\w");
    for (Path script : gradleScripts()) {
      assertThat(Repository.read(script))
          .as("%s: core plugins only", script)
          .doesNotContainPattern("\\bid\\s*\\(");
    }
  }

  @Test
  void bothBuildsPackWithTheSameScript() {
    Path root = Repository.root();
    assertThat(root.resolve("src/dist/pack")).isExecutable();
    assertThat(Repository.read(root.resolve("dfra"))).contains("src/dist/pack");
    assertThat(Repository.read(root.resolve("build.gradle.kts")))
        .contains("tasks.register<Exec>(\"dist\")", "src/dist/pack")
        .contains("tasks.register<Exec>(\"distComplete\")", "tasks.register<Exec>(\"distFlight\")")
        .as("the same bytes for the same sources, as outputTimestamp in pom.xml has it")
        .contains("isPreserveFileTimestamps = false", "isReproducibleFileOrder = true");
    assertThat(Repository.read(root.resolve("pom.xml")))
        .contains("<project.build.outputTimestamp>");
  }

  /** Maven's model has no place for a second folder of tests, so the comparison does not see it. */
  @Test
  void bothBuildsCompileTheSameFixturesForTheFlightDrivers() {
    Path flight = Repository.root().resolve("dfra-flight");
    String fixtures = "../dfra-drivers/src/test/java/org/dfra/drivers/fixture";
    assertThat(flight.resolve(fixtures)).isDirectory();
    assertThat(Repository.read(flight.resolve("pom.xml")))
        .contains(
            "<compileSourceRoot>${project.basedir}/src/test/java</compileSourceRoot>",
            "<compileSourceRoot>${project.basedir}/" + fixtures + "</compileSourceRoot>");
    assertThat(Repository.read(flight.resolve("build.gradle.kts")))
        .contains("sourceSets.test { java.srcDir(\"" + fixtures + "\") }");
  }

  /** The plugin's default is all tables, those of local variables too. */
  @Test
  void bothBuildsLeaveLocalVariablesOutOfMainClasses() {
    String pom = Repository.read(Repository.root().resolve("pom.xml"));
    assertThat(pom.substring(pom.indexOf("<id>default-compile</id>")))
        .containsOnlyOnce("<debuglevel>lines,source</debuglevel>");
    assertThat(Repository.read(Repository.root().resolve("build.gradle.kts")))
        .contains(
            "tasks.named<JavaCompile>(\"compileJava\") {"
                + " options.debugOptions.debugLevel = \"lines,source\" }");
  }

  @Test
  void testsDrawTheSameRandomNumbersInBothBuildsAndInEachRun() {
    String pom = Repository.read(Repository.root().resolve("pom.xml"));
    Matcher seed = Pattern.compile("<dfra\\.seed>(-?\\d+)</dfra\\.seed>").matcher(pom);
    assertThat(seed.find()).as("a number in pom.xml, dfra.seed").isTrue();
    assertThat(Repository.read(Repository.root().resolve("build.gradle.kts")))
        .contains("gradleProperty(\"dfra.seed\").getOrElse(\"" + seed.group(1) + "\")");
  }

  @Test
  void bothBuildsHandTheSamePropertiesToTheTests() {
    String pom = Repository.read(Repository.root().resolve("pom.xml"));
    String script =
        GradleBuild.withoutComments(Repository.read(Repository.root().resolve("build.gradle.kts")));
    String handed =
        pom.substring(
            pom.indexOf("<systemPropertyVariables>"), pom.indexOf("</systemPropertyVariables>"));
    assertThat(
            Pattern.compile("<(dfra\\.[\\w.-]+)>").matcher(handed).results().map(m -> m.group(1)))
        .contains("dfra.full", "dfra.test.repeats-overloaded", "dfra.soak", "dfra.seed")
        .allMatch(
            name ->
                script.contains("systemProperty(\"" + name + "\", ")
                    || script.contains("-D" + name + "="));
  }

  /** The accessor's first letters are small: Gradle answers "Unresolved reference: Java". */
  @Test
  void spellsTheCatalogsAccessorsAsGradleDoes() throws IOException {
    String inMaven = "<groupId>net.jini</groupId><artifactId>jsk-platform</artifactId>";
    for (Map.Entry<String, String> each :
        Map.of("Jini-Java.Core_Lib", "jini.java.core.lib", "jskLib", "jskLib").entrySet()) {
      house("api(rootProject.libs." + each.getValue() + ")", "");
      for (String pom : List.of("pom.xml", "dfra-b/pom.xml")) {
        Path file = elsewhere.resolve(pom);
        String renamed = inMaven.replace("jsk-platform", each.getKey());
        Files.writeString(file, Repository.read(file).replace(inMaven, renamed));
      }
      assertThat(differences(elsewhere)).isEmpty();
    }
    house("api(rootProject.libs.jsk.Platform)", "");
    assertThatThrownBy(() -> differences(elsewhere))
        .hasMessage("dfra-b: libs.jsk.Platform is no dependency managed in pom.xml");
  }

  /**
   * A lambda that names a task, a project or a script runs when the tasks do, where the
   * configuration cache keeps none of them.
   */
  @Test
  void whatGivesTestsTheirArgumentsCapturesNoTaskAndNoProject() {
    String script =
        GradleBuild.withoutComments(Repository.read(Repository.root().resolve("build.gradle.kts")));
    Matcher lambda = Pattern.compile("(?s)val dfraArguments = \\{(.*?)\\n    \\}").matcher(script);
    assertThat(lambda.find()).as("val dfraArguments = { ... } in build.gradle.kts").isTrue();
    assertThat(lambda.group(1))
        .contains("bootJar.get()")
        .doesNotContainPattern("activationJar|rootDir|rootProject|project\\(|layout|tasks");
    assertThat(script).contains("val bootJar = activationJar.flatMap { it.archiveFile }");
  }

  @Test
  void gradleHasTheCommandsOfARobotsLife() {
    String script = Repository.read(Repository.root().resolve("build.gradle.kts"));
    for (String verb : List.of("demo", "up", "down", "status")) {
      assertThat(script).contains("tasks.register<JavaExec>(\"" + verb + "\")");
    }
  }

  @Test
  void seesADependencyThatOneBuildLacks() throws IOException {
    house("", "");
    assertThat(differences(elsewhere))
        .containsExactly(
            "dfra-b needs net.jini:jsk-platform:2.2.2 (compile) only according to Maven");
  }

  @Test
  void seesADependencyOnlyGradleHas() throws IOException {
    house("api(rootProject.libs.jsk.platform)", "");
    Files.writeString(elsewhere.resolve("dfra-b/pom.xml"), "<project/>");
    assertThat(differences(elsewhere))
        .contains("dfra-b needs net.jini:jsk-platform:2.2.2 (compile) only according to Gradle");
  }

  @Test
  void seesAnotherScope() throws IOException {
    house("runtimeOnly(rootProject.libs.jsk.platform)", "");
    assertThat(differences(elsewhere))
        .containsExactly(
            "dfra-b needs net.jini:jsk-platform:2.2.2 (compile) only according to Maven",
            "dfra-b needs net.jini:jsk-platform:2.2.2 (runtime) only according to Gradle");
  }

  @Test
  void seesAnotherVersion() throws IOException {
    house("api(\"net.jini:jsk-platform:2.2.3\")", "");
    assertThat(differences(elsewhere))
        .containsExactly(
            "dfra-b needs net.jini:jsk-platform:2.2.2 (compile) only according to Maven",
            "dfra-b needs net.jini:jsk-platform:2.2.3 (compile) only according to Gradle");
  }

  @Test
  void seesAVersionOverriddenInAModulesPom() throws IOException {
    house("api(libs.jsk.platform)", "<version>2.2.1</version>");
    assertThat(differences(elsewhere))
        .contains("dfra-b needs net.jini:jsk-platform:2.2.1 (compile) only according to Maven");
  }

  @Test
  void providedIsOnTheTestsClassPathToo() throws IOException {
    house("compileOnly(libs.jsk.platform)", "<scope>provided</scope>");
    assertThat(differences(elsewhere))
        .contains(
            "dfra-b needs net.jini:jsk-platform:2.2.2 (compileOnly) only according to Gradle");
    house(
        "compileOnly(libs.jsk.platform); testCompileOnly(libs.jsk.platform)",
        "<scope>provided</scope>");
    assertThat(differences(elsewhere)).isEmpty();
  }

  @Test
  void seesAnAnnotationProcessorThatOneBuildLacks() throws IOException {
    house("annotationProcessor(libs.jsk.platform)", "");
    String processor =
        """
        <project><build><plugins><plugin><executions><execution><configuration>
          <annotationProcessorPaths combine.children="append"><path>
            <groupId>net.jini</groupId><artifactId>jsk-platform</artifactId><version>%s</version>
          </path></annotationProcessorPaths>
        </configuration></execution></executions></plugin></plugins></build></project>
        """;
    Path pom = elsewhere.resolve("dfra-b/pom.xml");
    Files.writeString(pom, processor.formatted("${river.version}"));
    assertThat(differences(elsewhere)).isEmpty();
    Files.writeString(pom, processor.formatted("2.2.1"));
    assertThat(differences(elsewhere))
        .containsExactly(
            "dfra-b needs net.jini:jsk-platform:2.2.1 (annotationProcessor) only according to"
                + " Maven",
            "dfra-b needs net.jini:jsk-platform:2.2.2 (annotationProcessor) only according to"
                + " Gradle");
    Files.writeString(pom, "<project/>");
    assertThat(differences(elsewhere))
        .containsExactly(
            "dfra-b needs net.jini:jsk-platform:2.2.2 (annotationProcessor) only according to"
                + " Gradle");
  }

  @Test
  void seesAModuleThatOneBuildLacks() throws IOException {
    house("api(rootProject.libs.jsk.platform)", "");
    assertThat(differences(elsewhere)).isEmpty();
    Files.createDirectories(elsewhere.resolve("dfra-c"));
    Files.writeString(elsewhere.resolve("dfra-c/build.gradle.kts"), "");
    assertThat(differences(elsewhere)).containsExactly("module dfra-c is only in Gradle");
    Files.delete(elsewhere.resolve("dfra-c/build.gradle.kts"));
    Files.delete(elsewhere.resolve("dfra-b/build.gradle.kts"));
    assertThat(differences(elsewhere)).containsExactly("module dfra-b is only in Maven");
  }

  @Test
  void refusesALineItCannotCompare() throws IOException {
    house("api(fileTree(\"lib\"))", "");
    assertThatThrownBy(() -> differences(elsewhere))
        .hasMessage("dfra-b: not a dependency line this test can compare: api(fileTree(\"lib\"))");
    house("api(rootProject.libs.nothing.known)", "");
    assertThatThrownBy(() -> differences(elsewhere))
        .hasMessage("dfra-b: libs.nothing.known is no dependency managed in pom.xml");
  }

  private static List<String> differences(Path root) {
    MavenBuild maven = new MavenBuild(root);
    BuildModel gradle = new GradleBuild(root, maven.managedVersions()).model();
    for (Set<Dependency> needs : gradle.modules().values()) {
      needs.remove(GRADLE_ONLY);
    }
    return maven.model().differencesFrom(gradle);
  }

  private static List<Path> gradleScripts() {
    Path root = Repository.root();
    return Stream.concat(
            Stream.of("settings.gradle.kts", "build.gradle.kts").map(root::resolve),
            Repository.modulesWith(root, "build.gradle.kts").stream()
                .map(module -> module.resolve("build.gradle.kts")))
        .toList();
  }

  /** A small house elsewhere: dfra-b needs jsk-platform, in Gradle by {@code line}. */
  private void house(String line, String inMaven) throws IOException {
    Map<String, String> files =
        Map.of(
            "pom.xml",
            """
            <project>
              <version>1</version>
              <modules><module>dfra-b</module><module>src/test</module></modules>
              <properties><river.version>2.2.2</river.version></properties>
              <dependencyManagement><dependencies>
                <dependency><groupId>net.jini</groupId><artifactId>jsk-platform</artifactId>
                  <version>${river.version}</version></dependency>
                <dependency><groupId>org.dfra</groupId><artifactId>dfra-b</artifactId>
                  <version>${project.version}</version></dependency>
              </dependencies></dependencyManagement>
            </project>
            """,
            "dfra-b/pom.xml",
            """
            <project><dependencies>
              <dependency><groupId>net.jini</groupId><artifactId>jsk-platform</artifactId>%s</dependency>
            </dependencies></project>
            """
                .formatted(inMaven),
            "src/test/pom.xml",
            "<project/>",
            "build.gradle.kts",
            "plugins { `java-library` }\n",
            "dfra-b/build.gradle.kts",
            "dependencies {\n    // why\n    %s\n}\n".formatted(line));
    for (Map.Entry<String, String> file : files.entrySet()) {
      Path path = elsewhere.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      Files.writeString(path, file.getValue());
    }
  }
}
