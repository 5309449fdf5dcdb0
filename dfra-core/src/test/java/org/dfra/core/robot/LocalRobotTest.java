package org.dfra.core.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.persona.DriveAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LocalRobotTest {

  @TempDir Path folder;

  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory();

  @AfterEach
  void end() {
    directory.close();
  }

  private RobotDescription robot(String... drivers) throws Exception {
    StringBuilder modules = new StringBuilder();
    for (int i = 0; i < drivers.length; i++) {
      Files.writeString(
          folder.resolve("m" + i + ".properties"),
          "server=a.Server\nproxy=a.Proxy\ndriver=" + drivers[i].replace("$", "$$") + "\n");
      modules.append("<module name=\"m%1$d\" properties=\"m%1$d.properties\"/>\n".formatted(i));
    }
    Path xml = folder.resolve("robot.xml");
    Files.writeString(
        xml,
        """
        <robot xmlns="urn:dfra:robot:1" name="atrv1" host="127.0.0.1">
        <group name="g">
        %s</group></robot>
        """
            .formatted(modules));
    return RobotXml.read(xml);
  }

  private LocalRobot make(RobotDescription description) {
    return new LocalRobot(
        description, directory, InstantSource.system(), path -> StateStore.inMemory());
  }

  @Test
  void startsOnceAndListsWhatItStarted() throws Exception {
    try (LocalRobot robot = make(robot(Lamp.class.getName(), Lamp.class.getName()))) {
      assertThat(directory.find(ModuleQuery.of(Module.class))).isEmpty();
      robot.start();
      robot.start();
      assertThat(directory.find(ModuleQuery.of(Module.class))).hasSize(2);
      assertThat(robot.module("m1", Lamp.class)).isPresent();
      assertThat(robot.module("m2", Lamp.class)).isEmpty();
    }
    assertThat(directory.find(ModuleQuery.of(Module.class))).isEmpty();
  }

  /** Modules that have been closed, in order. */
  private static final List<String> CLOSED = new CopyOnWriteArrayList<>();

  /** An effector that writes down when it was closed. */
  public static final class Wheels extends DriveImpl {
    public Wheels(ModuleContext context) {
      super(context, "wheels", "DFRA", "1", new DriveAttributes(1, 2, 1, 1), 0, List.of());
    }

    @Override
    protected void onStart() {}

    @Override
    protected void onClose() {
      CLOSED.add(path());
    }

    @Override
    protected void setVelocity(Velocity wanted) {}

    @Override
    protected void halt() {}

    @Override
    protected void brake(boolean set) {}
  }

  /** A module that moves nothing. */
  public static final class Mast extends ModuleImpl {
    public Mast(ModuleContext context) {
      super(context, "a mast", "DFRA", "1");
    }

    @Override
    protected void onStart() {}

    @Override
    protected void onClose() {
      CLOSED.add(path());
    }
  }

  @Test
  void closesWhatMovesTheRobotFirstAndThenTheLastThatWasStarted() throws Exception {
    CLOSED.clear();
    LocalRobot robot =
        make(robot(Wheels.class.getName(), Mast.class.getName(), Mast.class.getName()));
    robot.start();
    robot.close();
    assertThat(CLOSED).containsExactly("atrv1/m0", "atrv1/m2", "atrv1/m1");
  }

  @Test
  void closesAllThoughOneCannotBeClosed() throws Exception {
    LocalRobot robot =
        make(robot(Lamp.class.getName(), Jammed.class.getName(), Lamp.class.getName()));
    robot.start();
    List<ModuleImpl> modules = new ArrayList<>(robot.modules());
    assertThatThrownBy(robot::close).hasMessage("robot atrv1 did not end cleanly: it is jammed");
    assertThat(modules).allMatch(module -> module.readiness() == Readiness.STOPPED);
    assertThat(((Lamp) modules.get(0)).isOn).isFalse();
    assertThat(((Lamp) modules.get(2)).isOn).isFalse();
  }

  @Test
  void namesThePlaceWhereADriverIsNamedThatIsNotThere() throws Exception {
    RobotDescription description = robot(Lamp.class.getName(), "org.dfra.core.robot.Lantern");
    assertThatThrownBy(() -> make(description))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageStartingWith(folder.resolve("robot.xml") + ":4: module atrv1/m1: driver class")
        .hasMessageContaining("org.dfra.core.robot.Lantern is not on the group's class path");
  }

  /** No driver of dfra-flight is on this class path. */
  @Test
  void namesTheModuleThatHasTheDriverWhereThatIsNotInstalled() throws Exception {
    RobotDescription description = robot("org.dfra.drivers.uav.mavlink.MavlinkGpsImpl");
    assertThatThrownBy(() -> make(description))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            folder.resolve("robot.xml")
                + ":3: module atrv1/m0: driver class org.dfra.drivers.uav.mavlink.MavlinkGpsImpl is"
                + " in dfra-flight, which is not installed; \"dist --flight\" packs it");
  }

  /** Shines while it lives. */
  public static class Lamp extends ModuleImpl {

    volatile boolean isOn;

    public Lamp(ModuleContext context) {
      super(context, "a lamp", "DFRA", "1");
    }

    @Override
    protected void onStart() {
      isOn = true;
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {
      isOn = false;
    }
  }

  /** Cannot be closed. */
  public static final class Jammed extends Lamp {

    public Jammed(ModuleContext context) {
      super(context);
    }

    @Override
    protected void onClose() {
      throw new IllegalStateException("it is jammed");
    }
  }
}
