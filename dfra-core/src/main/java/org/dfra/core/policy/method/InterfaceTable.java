package org.dfra.core.policy.method;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.core.policy.method.InterfaceCatalogue.DeclaredKind;
import org.jspecify.annotations.Nullable;

/** Reads the table of DFRA's and River's remote interfaces, a resource of this package. */
final class InterfaceTable {

  private static final String TABLE = "remote-interfaces.tsv";

  private InterfaceTable() {}

  /** The text of the table. */
  static String read() {
    try (InputStream in = InterfaceTable.class.getResourceAsStream(TABLE)) {
      if (in == null) {
        throw new IOException("it is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new IllegalStateException(TABLE + " of this jar is damaged; rebuild DFRA", e);
    }
  }

  /**
   * The interfaces of a table by name, in its order. A line that begins with a name begins an
   * interface: its name, and after a tab the interfaces that it extends, which must be above it. A
   * line that begins with a tab is one of its methods: name, kind and reason, separated by tabs.
   */
  static Map<String, CataloguedInterface> parse(String table) {
    Map<String, CataloguedInterface> all = new LinkedHashMap<>();
    @Nullable CataloguedInterface current = null;
    for (String line : table.lines().toList()) {
      if (line.isBlank() || line.startsWith("#")) {
        continue;
      }
      List<String> cells = List.of(line.split("\t"));
      if (!line.startsWith("\t")) {
        current = begun(cells, all);
        all.put(current.name(), current);
      } else if (current == null || cells.size() != 4) {
        throw new IllegalStateException(TABLE + ": \"" + line + "\" is no method with its kind");
      } else {
        current
            .declared()
            .put(cells.get(1), new DeclaredKind(MethodKind.of(cells.get(2)), cells.get(3)));
        current.methods().add(cells.get(1));
      }
    }
    return all;
  }

  private static CataloguedInterface begun(
      List<String> cells, Map<String, CataloguedInterface> all) {
    Set<String> supers = new LinkedHashSet<>();
    Set<String> methods = new TreeSet<>();
    if (cells.size() > 1) {
      for (String each : cells.get(1).split(",")) {
        if (!all.containsKey(each)) {
          throw new IllegalStateException(
              TABLE + ": " + each + " must be above " + cells.get(0) + ", which extends it");
        }
        inherit(all.get(each), supers, methods);
      }
    }
    return new CataloguedInterface(cells.get(0), supers, new TreeMap<>(), methods);
  }

  /** Adds an interface and what it inherits itself to what another one inherits. */
  static void inherit(@Nullable CataloguedInterface from, Set<String> supers, Set<String> methods) {
    if (from != null) {
      supers.add(from.name());
      supers.addAll(from.superinterfaces());
      methods.addAll(from.methods());
    }
  }
}
