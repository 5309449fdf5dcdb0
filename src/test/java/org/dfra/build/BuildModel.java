package org.dfra.build;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * What one build makes of the house: its modules by directory, and what each needs.
 *
 * @param tool which build says so, for messages
 */
record BuildModel(String tool, Map<String, Set<Dependency>> modules) {

  /**
   * @param name group and artifact, as in {@code net.jini:jsk-platform}
   * @param scope in Maven's words: compile, provided, runtime or test; or {@code
   *     annotationProcessor}
   */
  record Dependency(String name, String version, String scope) implements Comparable<Dependency> {
    @Override
    public int compareTo(Dependency other) {
      return toString().compareTo(other.toString());
    }

    @Override
    public String toString() {
      return name + ":" + version + " (" + scope + ")";
    }
  }

  /** One sentence for each thing that only one of the two builds says; none if they agree. */
  List<String> differencesFrom(BuildModel other) {
    List<String> differences = new ArrayList<>();
    Set<String> all = new TreeSet<>(modules.keySet());
    all.addAll(other.modules.keySet());
    for (String module : all) {
      if (!modules.containsKey(module) || !other.modules.containsKey(module)) {
        differences.add(
            "module "
                + module
                + " is only in "
                + (modules.containsKey(module) ? tool : other.tool));
        continue;
      }
      addMissing(differences, module, this, other);
      addMissing(differences, module, other, this);
    }
    return differences;
  }

  private static void addMissing(
      List<String> differences, String module, BuildModel has, BuildModel lacks) {
    Set<Dependency> missing = new TreeSet<>(has.modules.get(module));
    missing.removeAll(lacks.modules.get(module));
    missing.forEach(
        dependency ->
            differences.add(module + " needs " + dependency + " only according to " + has.tool));
  }
}
