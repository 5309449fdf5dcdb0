package org.dfra.recruit.strategy;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.recruit.affect.Affect;
import org.jspecify.annotations.Nullable;

/**
 * The strategies by name: built-in ones by a keyword, any other by its class, {@code
 * org.example.Courteous}. Such a class is public, and has a public constructor with no parameters,
 * or with a {@link RandomGenerator} if it uses random numbers.
 */
public final class StrategyRegistry {

  /** The built-in ones. */
  public static final List<String> NAMES =
      List.of(Affective.NAME, Greedy.NAME, RandomPick.NAME, ContractNet.NAME);

  private StrategyRegistry() {}

  /**
   * Creates a strategy for one agent.
   *
   * @param name a keyword, or the name of a class
   * @param affect of the affective strategy
   * @param random of random strategies
   * @throws ConfigurationException if there is none of that name; the message lists the available
   *     ones
   */
  public static RecruitmentStrategy named(String name, Affect affect, RandomGenerator random) {
    return named(name, affect, random, RandomPick.DEFAULT_OFFER_PROBABILITY);
  }

  /**
   * Creates a strategy for one agent.
   *
   * @param name a keyword, or the name of a class
   * @param affect of the affective strategy
   * @param random of random strategies
   * @param offerProbability probability that a free robot offers with the random strategy, above 0
   *     and at most 1; a custom class has its own
   * @throws ConfigurationException if there is none of that name; the message lists the available
   *     ones
   */
  public static RecruitmentStrategy named(
      String name, Affect affect, RandomGenerator random, double offerProbability) {
    return switch (name) {
      case Affective.NAME -> new Affective(affect);
      case Greedy.NAME -> new Greedy();
      case RandomPick.NAME -> new RandomPick(random, offerProbability);
      case ContractNet.NAME -> new ContractNet();
      default -> ofClass(type(name), random);
    };
  }

  private static Class<?> type(String name) {
    if (!name.contains(".")) {
      throw new ConfigurationException(
          "unknown strategy \""
              + name
              + "\""
              + NearestName.hint(
                  name,
                  NAMES,
                  "; use " + String.join(", ", NAMES) + ", or a class by its full name"));
    }
    Class<?> type;
    try {
      type = Class.forName(name, true, Thread.currentThread().getContextClassLoader());
    } catch (ClassNotFoundException e) {
      throw fault(name, "is not on the class path; add its jar or correct the name", e);
    } catch (LinkageError e) {
      throw fault(name, "cannot be loaded (" + e + "); add the jar that it needs", e);
    }
    if (!RecruitmentStrategy.class.isAssignableFrom(type)) {
      throw fault(name, "does not implement " + RecruitmentStrategy.class.getName(), null);
    }
    return type;
  }

  private static RecruitmentStrategy ofClass(Class<?> type, RandomGenerator random) {
    try {
      Optional<Constructor<?>> byChance = constructor(type, RandomGenerator.class);
      if (byChance.isPresent()) {
        return (RecruitmentStrategy) byChance.get().newInstance(random);
      }
      Optional<Constructor<?>> plain = constructor(type);
      if (plain.isPresent()) {
        return (RecruitmentStrategy) plain.get().newInstance();
      }
    } catch (InvocationTargetException e) {
      throw fault(type.getName(), "cannot be instantiated: " + e.getCause(), e);
    } catch (ReflectiveOperationException e) {
      throw fault(type.getName(), "cannot be instantiated: " + e, e);
    }
    throw fault(type.getName(), "has no public constructor () or (RandomGenerator); add one", null);
  }

  private static Optional<Constructor<?>> constructor(Class<?> type, Class<?>... parameters) {
    for (Constructor<?> each : type.getConstructors()) {
      if (List.of(each.getParameterTypes()).equals(List.of(parameters))) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  private static ConfigurationException fault(String name, String what, @Nullable Throwable cause) {
    String message = "strategy class " + name + " " + what;
    return cause == null
        ? new ConfigurationException(message)
        : new ConfigurationException(message, cause);
  }
}
