package org.dfra.core.policy.method;

import java.lang.reflect.Method;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/**
 * The interfaces that clients call, with their methods: those of DFRA and of River, and those of
 * modules of your own. A policy may name these and no others. Immutable.
 *
 * <p>River's interfaces are known by name only, since a robot without a network has no River. The
 * table is the resource {@code remote-interfaces.tsv}; {@code RemoteMethodsTest} compares it with
 * the interfaces themselves.
 */
public final class InterfaceCatalogue {

  private static final InterfaceCatalogue BUILT_IN = parse(InterfaceTable.read());

  private final Map<String, CataloguedInterface> byName;
  private final @Nullable ClassLoader loader;

  private InterfaceCatalogue(
      Map<String, CataloguedInterface> byName, @Nullable ClassLoader loader) {
    this.loader = loader;
    Map<String, CataloguedInterface> frozen = new LinkedHashMap<>();
    byName.forEach((name, each) -> frozen.put(name, each.frozen()));
    this.byName = Collections.unmodifiableMap(frozen);
  }

  /**
   * What the table says about a method.
   *
   * @param reason why it is of this kind, in a few words
   */
  public record DeclaredKind(MethodKind kind, String reason) {}

  /**
   * One interface.
   *
   * @param name its full name
   * @param superinterfaces full names of those in this catalogue, also the indirect ones
   * @param declared the methods that it declares itself, with their kinds; overloads share a name
   * @param methods the names of all its methods, also the inherited ones
   */
  public record CataloguedInterface(
      String name,
      Set<String> superinterfaces,
      Map<String, DeclaredKind> declared,
      Set<String> methods) {

    /** The name without its package, and without the class that it is nested in. */
    public String simpleName() {
      return name.substring(Math.max(name.lastIndexOf('.'), name.lastIndexOf('$')) + 1);
    }

    private CataloguedInterface frozen() {
      return new CataloguedInterface(
          name,
          Collections.unmodifiableSet(superinterfaces),
          Collections.unmodifiableMap(declared),
          Collections.unmodifiableSet(methods));
    }
  }

  /** The interfaces of DFRA and River. */
  public static InterfaceCatalogue builtIn() {
    return BUILT_IN;
  }

  /**
   * This catalogue with further interfaces, and with those that they extend.
   *
   * @param interfaces of modules of your own; the annotations of their methods say their kinds
   */
  public InterfaceCatalogue with(Collection<Class<?>> interfaces) {
    Map<String, CataloguedInterface> all = new LinkedHashMap<>(byName);
    interfaces.forEach(each -> add(each, all));
    return new InterfaceCatalogue(all, loader);
  }

  /**
   * This catalogue with all interfaces that a class loader finds. They must be named in full.
   *
   * @param loader of the classes of modules of your own
   */
  public InterfaceCatalogue withInterfacesOf(ClassLoader loader) {
    return new InterfaceCatalogue(byName, loader);
  }

  private Optional<CataloguedInterface> load(String name) {
    try {
      Class<?> type = loader == null ? null : Class.forName(name, false, loader);
      return type == null || !type.isInterface()
          ? Optional.empty()
          : with(List.of(type)).find(name);
    } catch (ClassNotFoundException e) {
      return Optional.empty(); // the reader of the policy reports it
    }
  }

  private static void add(Class<?> type, Map<String, CataloguedInterface> all) {
    if (all.containsKey(type.getName())) {
      return;
    }
    Set<String> supers = new TreeSet<>();
    Set<String> methods = new TreeSet<>();
    for (Class<?> each : type.getInterfaces()) {
      add(each, all);
      InterfaceTable.inherit(all.get(each.getName()), supers, methods);
    }
    Map<String, DeclaredKind> declared = new TreeMap<>();
    for (Method each : type.getDeclaredMethods()) {
      MethodKinds.Classification kind = MethodKinds.of(type, each);
      declared.put(each.getName(), new DeclaredKind(kind.kind(), kind.reason()));
      methods.add(each.getName());
    }
    all.put(type.getName(), new CataloguedInterface(type.getName(), supers, declared, methods));
  }

  /** All interfaces, superinterfaces first. */
  public Collection<CataloguedInterface> all() {
    return byName.values();
  }

  /** The interface with a full name. */
  public Optional<CataloguedInterface> find(String fullName) {
    return Optional.ofNullable(byName.get(fullName));
  }

  /** The interfaces with a name, which may be full or without its package. */
  public List<CataloguedInterface> named(String name) {
    return name.indexOf('.') >= 0
        ? find(name).or(() -> load(name)).stream().toList()
        : byName.values().stream().filter(each -> each.simpleName().equals(name)).toList();
  }

  /** The names of all interfaces without their packages, in alphabetical order. */
  public Set<String> simpleNames() {
    Set<String> names = new TreeSet<>();
    byName.values().forEach(each -> names.add(each.simpleName()));
    return names;
  }

  /** The names of all methods, in alphabetical order. */
  public Set<String> methodNames() {
    Set<String> names = new TreeSet<>();
    byName.values().forEach(each -> names.addAll(each.methods()));
    return names;
  }

  /** The catalogue of a table; see {@link InterfaceTable}. */
  public static InterfaceCatalogue parse(String table) {
    return new InterfaceCatalogue(InterfaceTable.parse(table), null);
  }
}
