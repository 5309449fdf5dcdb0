package org.dfra.river.bootstrap;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeSet;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.river.server.ModuleActivation;
import org.jspecify.annotations.Nullable;

/** The differences between two activations of a module. */
final class ActivationChanges {

  private ActivationChanges() {}

  /**
   * Lists the changes that require a restart of a running module, in words such as {@code parameter
   * link}. Line numbers in a file are ignored, and so are settings that apply only after a crash.
   *
   * @param old the current activation
   * @param wanted the new activation
   */
  static List<String> between(ModuleActivation old, ModuleActivation wanted) {
    List<String> changes = new ArrayList<>();
    ModuleDescription before = old.module();
    ModuleDescription after = wanted.module();
    add(changes, "server", before.serverClass(), after.serverClass());
    add(changes, "proxy", before.proxyClass(), after.proxyClass());
    add(changes, "implementation", before.driverClass(), after.driverClass());
    add(changes, "configuration", before.configuration(), after.configuration());
    add(changes, "codebase", before.codebase(), after.codebase());
    addParameters(changes, before.parameters(), after.parameters());
    add(changes, "host", old.host(), wanted.host());
    add(changes, "lookup groups", old.lookupGroups(), wanted.lookupGroups());
    add(changes, "lookup locators", old.locators(), wanted.locators());
    add(changes, "state folder", old.state(), wanted.state());
    return changes;
  }

  private static void addParameters(List<String> changes, Parameters before, Parameters after) {
    Map<String, Parameters.Value> olds = before.all();
    Map<String, Parameters.Value> news = after.all();
    TreeSet<String> names = new TreeSet<>(olds.keySet());
    names.addAll(news.keySet());
    for (String name : names) {
      add(changes, "parameter " + name, text(olds.get(name)), text(news.get(name)));
    }
  }

  private static @Nullable String text(Parameters.@Nullable Value value) {
    return value == null ? null : value.text();
  }

  private static void add(
      List<String> changes, String what, @Nullable Object before, @Nullable Object after) {
    if (!Objects.equals(before, after)) {
      changes.add(what);
    }
  }
}
