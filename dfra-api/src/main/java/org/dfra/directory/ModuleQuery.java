package org.dfra.directory;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.LocationAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A query for modules that implement an interface and meet every added condition. Immutable; each
 * method returns a new query. An invalid condition is refused when it is added.
 *
 * <pre>{@code
 * ModuleQuery.of(LocationSensor.class)
 *     .where(SensorAttributes.class, "maxRate", Condition.atLeast(1))   // Hz
 *     .where(GpsReceiverAttributes.class, "fixModes", Condition.contains("3D"))
 *     .within(50, here)                                                 // metres
 * }</pre>
 *
 * @param <M> the interface
 */
public final class ModuleQuery<M extends Module> {

  private final Class<M> kind;
  private final @Nullable String robot;
  private final @Nullable String name;
  private final List<AttributeCondition> tests;
  private final @Nullable Circle circle;
  private final List<Predicate<ModuleListing<?>>> others;

  /** Round a point whose height is 0, since height does not count. */
  private record Circle(double radius, GeoPosition centre) {
    Circle {
      centre = new GeoPosition(centre.latitude(), centre.longitude(), 0);
    }
  }

  private ModuleQuery(
      Class<M> kind,
      @Nullable String robot,
      @Nullable String name,
      List<AttributeCondition> tests,
      @Nullable Circle circle,
      List<Predicate<ModuleListing<?>>> others) {
    this.kind = kind;
    this.robot = robot;
    this.name = name;
    this.tests = tests;
    this.circle = circle;
    this.others = others;
  }

  /**
   * Every module of a kind, on any robot.
   *
   * @throws IllegalArgumentException if {@code kind} is not an interface
   */
  public static <M extends Module> ModuleQuery<M> of(Class<M> kind) {
    if (!kind.isInterface()) {
      throw new IllegalArgumentException(
          kind.getName() + " is a class; ask for an interface, since a proxy is of another class");
    }
    return new ModuleQuery<>(kind, null, null, List.of(), null, List.of());
  }

  /**
   * The same by the interface's full name, as an operator enters it.
   *
   * @throws IllegalArgumentException if there is no such interface, or it is not a module's
   */
  public static ModuleQuery<? extends Module> ofKind(String kind) {
    @Nullable ClassLoader context = Thread.currentThread().getContextClassLoader();
    try {
      Class<?> type =
          Class.forName(
              kind, false, context != null ? context : ModuleQuery.class.getClassLoader());
      if (!Module.class.isAssignableFrom(type)) {
        throw new IllegalArgumentException(
            kind
                + " is no kind of module; name an interface that extends "
                + Module.class.getName());
      }
      return of(type.asSubclass(Module.class));
    } catch (ClassNotFoundException | LinkageError e) {
      throw new IllegalArgumentException(
          "there is no module type \""
              + kind
              + "\"; write the full name of an interface, such as"
              + " org.dfra.flow.sensor.GPSSensor",
          e);
    }
  }

  /** Only on this robot. */
  public ModuleQuery<M> robot(String wanted) {
    return new ModuleQuery<>(kind, wanted, name, tests, circle, others);
  }

  /** Only with this name. */
  public ModuleQuery<M> name(String wanted) {
    return new ModuleQuery<>(kind, robot, wanted, tests, circle, others);
  }

  /**
   * Only where a component of an attribute record meets a condition.
   *
   * @throws IllegalArgumentException if the record has no such component, or its type does not fit
   *     the condition, such as a range of texts
   */
  public ModuleQuery<M> where(
      Class<? extends Attributes> type, String component, Condition condition) {
    List<AttributeCondition> more = new ArrayList<>(tests);
    more.add(AttributeCondition.of(type, component, condition));
    return new ModuleQuery<>(kind, robot, name, List.copyOf(more), circle, others);
  }

  /**
   * Only where a predicate of the caller holds, which may use more than attributes. It is evaluated
   * last, on any thread, at every evaluation of the query, so it must be fast, and return the same
   * result for the same listing. The query's text does not contain it.
   */
  public ModuleQuery<M> where(Predicate<ModuleListing<?>> test) {
    List<Predicate<ModuleListing<?>>> more = new ArrayList<>(others);
    more.add(test);
    return new ModuleQuery<>(kind, robot, name, tests, circle, List.copyOf(more));
  }

  /**
   * Only near a position. A module's position is that of its {@link LocationAttributes}. Without
   * them it is the position of its robot, from the attributes of the robot's other modules on the
   * same host. A module on a robot without a position matches no circle.
   *
   * @param radius the greatest distance in metres, as {@link GeoPosition#groundDistance}
   * @throws IllegalArgumentException if the distance is negative or NaN
   */
  public ModuleQuery<M> within(double radius, GeoPosition position) {
    if (!(radius >= 0)) {
      throw new IllegalArgumentException(
          "no module is within " + radius + " m; ask for 0 m or more");
    }
    return new ModuleQuery<>(kind, robot, name, tests, new Circle(radius, position), others);
  }

  /** The interface that is queried. */
  public Class<M> kind() {
    return kind;
  }

  /** The robot that is queried; empty for any robot. */
  public Optional<String> robot() {
    return Optional.ofNullable(robot);
  }

  /**
   * Whether a module matches the query.
   *
   * @param positionOfRobot returns the position of the robot of a module
   */
  public boolean matches(
      ModuleListing<?> candidate,
      Function<ModuleListing<?>, Optional<GeoPosition>> positionOfRobot) {
    if (!kind.isInstance(candidate.module())
        || (robot != null && !robot.equals(candidate.robot()))
        || (name != null && !name.equals(candidate.name()))) {
      return false;
    }
    for (AttributeCondition test : tests) {
      if (!test.test(candidate.attributes())) {
        return false;
      }
    }
    return (circle == null || isNear(circle, candidate, positionOfRobot))
        && others.stream().allMatch(each -> each.test(candidate));
  }

  private static boolean isNear(
      Circle circle,
      ModuleListing<?> candidate,
      Function<ModuleListing<?>, Optional<GeoPosition>> robots) {
    return candidate
        .attributes(LocationAttributes.class)
        .map(LocationAttributes::position)
        .or(() -> robots.apply(candidate))
        .filter(position -> position.groundDistance(circle.centre()) <= circle.radius())
        .isPresent();
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof ModuleQuery<?> query
        && kind == query.kind
        && Objects.equals(robot, query.robot)
        && Objects.equals(name, query.name)
        && tests.equals(query.tests)
        && Objects.equals(circle, query.circle)
        && others.equals(query.others);
  }

  @Override
  public int hashCode() {
    return Objects.hash(kind, robot, name, tests, circle, others);
  }

  /**
   * The query as text, usable after "there is no …", and as {@code ./dfra persona find} and the
   * query parser of dfra-core read it.
   */
  @Override
  public String toString() {
    StringBuilder words = new StringBuilder(kind.getSimpleName());
    if (name != null) {
      words.append(" named ").append(QueryFormatter.name(name));
    }
    if (robot != null) {
      words.append(" on ").append(QueryFormatter.name(robot));
    }
    String joint = " with ";
    for (AttributeCondition test : tests) {
      words.append(joint).append(test);
      joint = " and ";
    }
    if (circle != null) {
      GeoPosition centre = circle.centre();
      words.append(" within ").append(circle.radius()).append(" m of ");
      words.append(centre.latitude()).append("°, ").append(centre.longitude()).append('°');
    }
    return words.toString();
  }
}
