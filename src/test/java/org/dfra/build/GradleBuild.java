package org.dfra.build;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.dfra.build.BuildModel.Dependency;

/**
 * Reads the {@code build.gradle.kts} files: every {@code dependencies} block, line by line, against
 * a strict pattern. A line it does not know is an error, for a line that is skipped is a dependency
 * that is not compared.
 */
final class GradleBuild {

  /** The root project's own sources are {@code src/test}. */
  private static final String ROOT_PROJECT = "src/test";

  private static final String PROJECT_GROUP = "org.dfra:";

  private static final Pattern BLOCK = Pattern.compile("\\bdependencies\\s*\\{");
  private static final Pattern ALL_PROJECTS = Pattern.compile("\\ballprojects\\s*\\{");
  private static final Pattern LINE =
      Pattern.compile(
          "\"?(?<configuration>\\w+)\"?\\((?:project\\(\":(?<project>[\\w-]+)\"\\)"
              + "|(?:rootProject\\.)?libs\\.(?<alias>[\\w.]+)"
              + "|\"(?<name>[\\w.-]+:[\\w.-]+)(?<version>:[^\"]+)?\")\\)");

  /**
   * Gradle's configurations in Maven's words; several of one dependency are joined by "+". A module
   * may need at run time what all need for their tests. Maven has no scope for annotation
   * processors.
   */
  private static final Map<String, String> SCOPES =
      Map.of(
          "api", "compile",
          "implementation", "compile",
          "runtimeOnly", "runtime",
          "testImplementation", "test",
          "testRuntimeOnly", "test",
          "api+testImplementation", "compile",
          "implementation+testImplementation", "compile",
          "compileOnly+testCompileOnly", "provided",
          "compileOnly+testImplementation", "provided");

  private final Path root;
  private final Map<String, String> versions;

  /**
   * @param versions of the managed dependencies by {@code group:artifact}: what the catalog is made
   *     of
   */
  GradleBuild(Path root, Map<String, String> versions) {
    this.root = root;
    this.versions = versions;
  }

  BuildModel model() {
    Map<String, Set<Dependency>> modules = new LinkedHashMap<>();
    String rootScript = withoutComments(Repository.read(root.resolve("build.gradle.kts")));
    List<String> forAll = new ArrayList<>();
    List<String> forRoot = new ArrayList<>();
    List<int[]> allprojects =
        ALL_PROJECTS
            .matcher(rootScript)
            .results()
            .map(found -> new int[] {found.end(), endOfBlock(rootScript, found.end())})
            .toList();
    Matcher block = BLOCK.matcher(rootScript);
    while (block.find()) {
      int at = block.start();
      boolean all = allprojects.stream().anyMatch(range -> range[0] < at && at < range[1]);
      (all ? forAll : forRoot).addAll(lines(rootScript, block.end()));
    }
    for (Path module : Repository.modulesWith(root, "build.gradle.kts")) {
      String script = withoutComments(Repository.read(module.resolve("build.gradle.kts")));
      List<String> lines = new ArrayList<>(forAll);
      BLOCK.matcher(script).results().forEach(found -> lines.addAll(lines(script, found.end())));
      modules.put(
          module.getFileName().toString(), dependencies(module.getFileName().toString(), lines));
    }
    forRoot.addAll(forAll);
    modules.put(ROOT_PROJECT, dependencies(ROOT_PROJECT, forRoot));
    return new BuildModel("Gradle", modules);
  }

  private Set<Dependency> dependencies(String module, List<String> lines) {
    Map<String, Set<String>> configurations = new TreeMap<>();
    Map<String, String> literalVersions = new TreeMap<>();
    for (String line : lines) {
      Matcher matcher = LINE.matcher(line);
      if (!matcher.matches()) {
        throw new IllegalStateException(
            module + ": not a dependency line this test can compare: " + line);
      }
      String name = name(module, matcher);
      if (matcher.group("version") != null) {
        literalVersions.put(name, matcher.group("version").substring(1));
      }
      if (!configurations
          .computeIfAbsent(name, key -> new TreeSet<>())
          .add(matcher.group("configuration"))) {
        throw new IllegalStateException(module + ": twice the same: " + line);
      }
    }
    Set<Dependency> result = new TreeSet<>();
    configurations.forEach(
        (name, uses) -> {
          String version =
              literalVersions.getOrDefault(name, versions.getOrDefault(name, "no managed version"));
          result.add(new Dependency(name, version, scope(module, String.join("+", uses))));
        });
    return result;
  }

  private String name(String module, Matcher line) {
    if (line.group("project") != null) {
      return PROJECT_GROUP + line.group("project");
    }
    if (line.group("name") != null) {
      return line.group("name");
    }
    String alias = line.group("alias");
    return versions.keySet().stream()
        .filter(name -> !name.startsWith(PROJECT_GROUP))
        .filter(name -> alias(name.substring(name.indexOf(':') + 1)).equals(alias))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalStateException(
                    module + ": libs." + alias + " is no dependency managed in pom.xml"));
  }

  /**
   * As settings.gradle.kts names it, and as the catalog's accessor spells that: Gradle splits an
   * alias at {@code -}, {@code _} and {@code .}, makes a getter of each segment, and Kotlin spells
   * the property with a small first letter.
   */
  private static String alias(String artifact) {
    return Pattern.compile("[-_.]")
        .splitAsStream(artifact)
        .map(segment -> Character.toLowerCase(segment.charAt(0)) + segment.substring(1))
        .collect(Collectors.joining("."));
  }

  /**
   * Unknown combinations come back as they are: they equal no scope of Maven's, so the comparison
   * shows them.
   */
  private static String scope(String module, String configurations) {
    return module.equals(ROOT_PROJECT) && configurations.equals("testCompileOnly")
        ? "provided"
        : SCOPES.getOrDefault(configurations, configurations);
  }

  private static List<String> lines(String script, int start) {
    return script
        .substring(start, endOfBlock(script, start))
        .lines()
        .flatMap(line -> Pattern.compile(";").splitAsStream(line))
        .map(String::trim)
        .filter(line -> !line.isEmpty())
        .toList();
  }

  private static int endOfBlock(String script, int start) {
    int depth = 1;
    for (int i = start; i < script.length(); i++) {
      depth += script.charAt(i) == '{' ? 1 : script.charAt(i) == '}' ? -1 : 0;
      if (depth == 0) {
        return i;
      }
    }
    throw new IllegalStateException(
        "a block of a build script does not end: " + script.substring(start));
  }

  static String withoutComments(String script) {
    return script.replaceAll("(?m)(^|\\s)//.*$", "").replaceAll("(?s)/\\*.*?\\*/", "");
  }
}
