package org.dfra.core.module;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.Parameters;
import org.jspecify.annotations.Nullable;

/**
 * Constructs a driver, and finds everything that is wrong with its parameters. A driver's
 * constructor ends at the first wrong value. So it is tried again without that one, until it comes
 * to its end: only then is it known which parameters it has.
 */
final class DriverFactory {

  private final String module;
  private final ModuleContext context;
  private final BiConsumer<String, Class<?>> needs;
  private final Set<String> asked = ConcurrentHashMap.newKeySet();
  private final Set<String> refused = new HashSet<>();
  private final Map<String, Class<?>> needed = new LinkedHashMap<>();
  private final List<ConfigurationException> faults = new ArrayList<>();
  private volatile @Nullable String wrong; // the parameter refused last in the trial under way

  /**
   * @param module the module's path, {@code robot/name}
   * @param needs is given each other module that the driver needs: the parameter that may name it,
   *     and of which kind it must be
   */
  DriverFactory(String module, ModuleContext context, BiConsumer<String, Class<?>> needs) {
    this.module = module;
    this.context = context;
    this.needs = needs;
  }

  private final class Reading implements Parameters.ParameterAccessListener {
    @Override
    public void onRead(String name) {
      asked.add(name);
    }

    @Override
    public void onModuleReference(String name, Class<?> kind) {
      needed.put(name, kind);
    }

    @Override
    public void onInvalid(String name) {
      wrong = name;
    }
  }

  /**
   * Constructs it.
   *
   * @param constructor makes a driver of its context
   * @throws ConfigurationException naming everything that is wrong, a line each
   */
  ModuleImpl construct(Function<ModuleContext, ModuleImpl> constructor) {
    try {
      Optional<ModuleImpl> driver = completed(constructor);
      driver.ifPresent(unused -> findUnknown());
      if (faults.isEmpty()) {
        return driver.orElseThrow();
      }
      driver.ifPresent(ModuleImpl::close);
      throw combinedFault();
    } finally {
      needed.forEach(needs);
    }
  }

  /** Empty where something stops the constructor for which there is no way around. */
  private Optional<ModuleImpl> completed(Function<ModuleContext, ModuleImpl> constructor) {
    Parameters parameters = context.parameters().withListener(new Reading());
    while (true) {
      wrong = null;
      try {
        return Optional.of(constructor.apply(context.with(parameters)));
      } catch (ConfigurationException e) {
        @Nullable String name = wrong;
        if (name != null && refused.contains(name)) {
          return Optional.empty(); // it is missing only because it was taken away
        }
        faults.add(e);
        if (name == null || !parameters.all().containsKey(name)) {
          return Optional.empty();
        }
        refused.add(name);
        parameters = parameters.without(name);
      }
    }
  }

  private void findUnknown() {
    for (Map.Entry<String, Parameters.Value> each : context.parameters().all().entrySet()) {
      if (!asked.contains(each.getKey())) {
        faults.add(
            new ConfigurationException(
                each.getValue().place()
                    + ": "
                    + module
                    + " has no parameter \""
                    + each.getKey()
                    + "\""
                    + NearestName.hint(
                        each.getKey(),
                        asked,
                        "; it has " + String.join(", ", new TreeSet<>(asked)))));
      }
    }
  }

  private ConfigurationException combinedFault() {
    return faults.size() == 1
        ? faults.get(0)
        : new ConfigurationException(
            faults.stream().map(Throwable::getMessage).collect(Collectors.joining("\n")));
  }
}
