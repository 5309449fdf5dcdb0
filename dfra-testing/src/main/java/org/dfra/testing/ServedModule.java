package org.dfra.testing;

import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.stream.Collectors;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.RobotXml;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.module.ModuleImpl;
import org.dfra.module.Module;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleIdentity;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/**
 * A module to be served in the test's own virtual machine, as a group serves it, but without an
 * activation system. Immutable.
 *
 * <pre>{@code
 * ServedModule<GPSServer> gps =
 *     ServedModule.of(GPSServer.class, GPSProxy.class, M12PlusImpl.class)
 *         .with("link", "replay:recording.bin")
 *         .joining(reggie);
 * try (GPSServer server = gps.serve()) {
 *   ... // found in the registrar, called through its proxy
 * }
 * }</pre>
 *
 * <p>Serving executes the real six activation steps. Serving again after the server was closed
 * simulates a reactivation: the identity is the same.
 *
 * @param activation the activation data of the server's constructor
 * @param server the server's class; it has a constructor {@code (ActivationID, MarshalledObject)}
 */
public record ServedModule<S extends ModuleServer<?>>(
    Class<S> server, ModuleActivation activation) {

  /**
   * A module made of these classes: {@code robot/module}, with a new identity, joining no lookup
   * service.
   */
  public static <S extends ModuleServer<?>> ServedModule<S> of(
      Class<S> server, Class<? extends ModuleProxy<?>> proxy, Class<? extends ModuleImpl> driver) {
    ModuleDescription description =
        new ModuleDescription(
            "robot",
            "module",
            server.getName(),
            proxy.getName(),
            driver.getName(),
            null,
            false,
            new Parameters("robot/module", Map.of()),
            SourceLocation.CODE);
    return new ServedModule<>(
        server,
        new ModuleActivation(
            description, UUID.randomUUID(), EmbeddedReggie.HOST, List.of(), List.of()));
  }

  /**
   * The module {@code robot/name}, as a robot's XML and the properties that come with DFRA describe
   * it: with a new identity, joining no lookup service.
   *
   * @param folder the folder in which the XML is written, {@code name.xml}; its fourth line is the
   *     first parameter
   * @param properties name of a file in {@code config/modules} of the checkout that the system
   *     property {@code dfra.root} names, without its extension
   * @param parameters the parameters in the XML, in the order of the map
   * @throws IllegalStateException if {@code dfra.root} is not set
   * @throws Exception if the description is invalid, or a class is missing
   */
  public static ServedModule<?> fromProperties(
      Path folder, String name, String properties, Map<String, String> parameters)
      throws Exception {
    String root = System.getProperty("dfra.root");
    if (root == null) {
      throw new IllegalStateException(
          "system property dfra.root is not set; set it to a checkout of DFRA or an installation,"
              + " whose config/modules is read");
    }
    Path modules = Path.of(root, "config", "modules");
    Path xml =
        Files.writeString(
            folder.resolve(name + ".xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="robot" host="127.0.0.1">
              <group name="all">
                <module name="%s" properties="%s">
            %s
                </module>
              </group>
            </robot>
            """
                .formatted(
                    name,
                    modules.resolve(properties + ".properties"),
                    parameters.entrySet().stream()
                        .map(
                            each ->
                                "      <parameter name=\"%s\" value=\"%s\"/>"
                                    .formatted(each.getKey(), each.getValue()))
                        .collect(Collectors.joining("\n"))));
    return of(RobotXml.read(xml).groups().get(0).modules().get(0));
  }

  /**
   * The same with a check of its server and proxy classes.
   *
   * @throws AssertionError if they differ
   */
  public static <S extends ModuleServer<?>> ServedModule<S> fromProperties(
      Class<S> server,
      Class<? extends ModuleProxy<? extends Module>> proxy,
      Path folder,
      String name,
      String properties,
      Map<String, String> parameters)
      throws Exception {
    ModuleActivation activation = fromProperties(folder, name, properties, parameters).activation();
    same("server", activation.module().serverClass(), server);
    same("proxy", activation.module().proxyClass(), proxy);
    return new ServedModule<>(server, activation);
  }

  private static void same(String what, String described, Class<?> expected) {
    if (!described.equals(expected.getName())) {
      throw new AssertionError(
          "the module's " + what + " is " + described + ", expected was " + expected.getName());
    }
  }

  @SuppressWarnings("unchecked")
  private static ServedModule<?> of(ModuleDescription described) throws ClassNotFoundException {
    return of(
            (Class<? extends ModuleServer<?>>) Class.forName(described.serverClass()),
            (Class<? extends ModuleProxy<?>>) Class.forName(described.proxyClass()),
            Class.forName(described.driverClass()).asSubclass(ModuleImpl.class))
        .withDescription(described);
  }

  /** A copy with another robot. */
  public ServedModule<S> on(String robot) {
    return withDescription(activation.module().withRobot(robot));
  }

  /** A copy with another name. */
  public ServedModule<S> named(String name) {
    return withDescription(activation.module().withName(name));
  }

  /** A copy with another driver, and without parameters, since they are specific to a driver. */
  public ServedModule<S> withDriver(Class<? extends ModuleImpl> driver) {
    return withDescription(activation.module().withBareDriver(driver.getName()));
  }

  /** A copy with another parameter for its driver. */
  public ServedModule<S> with(String parameter, String value) {
    return with(parameter, value, SourceLocation.CODE);
  }

  /** A copy with another parameter for its driver, as if configured at that place. */
  public ServedModule<S> with(String parameter, String value, SourceLocation place) {
    return withDescription(activation.module().withParameter(parameter, value, place));
  }

  /** A copy with another description. */
  public ServedModule<S> withDescription(ModuleDescription description) {
    return activated(
        description, activation.id(), activation.host(), activation.locators(), activation.state());
  }

  /** A copy with another identity. */
  public ServedModule<S> withId(UUID id) {
    return activated(
        activation.module(), id, activation.host(), activation.locators(), activation.state());
  }

  /** A copy with another host name or address, which must be one of this computer's. */
  public ServedModule<S> at(String host) {
    return activated(
        activation.module(), activation.id(), host, activation.locators(), activation.state());
  }

  /** A copy that joins this lookup service. */
  public ServedModule<S> joining(EmbeddedReggie reggie) {
    return joining(reggie.locator());
  }

  /** A copy that joins the lookup service at this locator. */
  public ServedModule<S> joining(String locator) {
    return joining(List.of(locator));
  }

  /** A copy that joins the lookup services at these locators. */
  public ServedModule<S> joining(List<String> locators) {
    return activated(
        activation.module(), activation.id(), activation.host(), locators, activation.state());
  }

  /**
   * A copy that uses the state folder of a running robot: it stores its persistent state there,
   * including its identity, and treats only modules registered there as its robot's own. Set robot
   * and name before.
   *
   * @param state the robot's state folder; another robot of that name on this computer has another
   *     one
   * @throws IOException if its identity cannot be written
   */
  public ServedModule<S> withStateFolder(Path state) throws IOException {
    ModuleDescription module = activation.module();
    Path folder =
        state.toAbsolutePath().resolve("modules").resolve(module.robot()).resolve(module.name());
    new ModuleIdentity(activation.id(), activation.created()).store(folder);
    return activated(
        module, activation.id(), activation.host(), activation.locators(), folder.toString());
  }

  private ServedModule<S> activated(
      ModuleDescription module,
      UUID id,
      String host,
      List<String> locators,
      @Nullable String state) {
    return new ServedModule<>(
        server,
        new ModuleActivation(
            module, id, activation.created(), host, activation.lookupGroups(), locators, state));
  }

  /**
   * Serves it until the server is closed.
   *
   * @throws Exception the exception of the server's constructor, or of its start
   */
  public S serve() throws Exception {
    Constructor<S> constructor =
        server.getDeclaredConstructor(ActivationID.class, MarshalledObject.class);
    constructor.setAccessible(true);
    S made;
    try {
      made = constructor.newInstance(null, new MarshalledObject<>(activation));
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof Exception cause) {
        throw cause;
      }
      throw e;
    }
    return ModuleServer.started(made);
  }
}
