package org.dfra.core.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.core.module.ModuleImpl;
import org.dfra.module.Module;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RobotDryRunTest {

  private static final String CLASSES = " server=\"java.lang.Object\" proxy=\"java.lang.Object\"";

  @TempDir Path folder;

  private static String module(String name, Class<?> driver, String parameters) {
    return "<module name=\""
        + name
        + "\""
        + CLASSES
        + " implementation=\""
        + driver.getName().replace("$", "$$")
        + "\">"
        + parameters
        + "</module>\n";
  }

  private static String named(String lamp) {
    return "<parameter name=\"lamp\" value=\"" + lamp + "\"/>";
  }

  private static String group(String attributes, String... modules) {
    return "<group " + attributes + ">\n" + String.join("", modules) + "</group>\n";
  }

  private RobotDescription robot(String... groups) throws Exception {
    Path xml = folder.resolve("robot.xml");
    Files.writeString(
        xml,
        "<robot xmlns=\"urn:dfra:robot:1\" name=\"atrv1\" host=\"127.0.0.1\">\n"
            + String.join("", groups)
            + "</robot>\n");
    return RobotXml.read(xml);
  }

  private List<String> faults(Consumer<RobotDescription> trial, RobotDescription robot) {
    ConfigurationException fault =
        catchThrowableOfType(ConfigurationException.class, () -> trial.accept(robot));
    assertThat(fault).as("it is refused").isNotNull();
    String place = folder.resolve("robot.xml") + ":";
    return fault.getMessage().lines().map(line -> line.replace(place, "")).toList();
  }

  private List<String> faultsOf(String... modules) throws Exception {
    return faults(RobotDryRun::check, robot(group("name=\"a\"", modules)));
  }

  @Test
  void takesARobotThatHasAllThatItNeeds() throws Exception {
    RobotDescription robot =
        robot(
            group("name=\"a\"", module("switch", Switch.class, named("lamp"))),
            group("name=\"b\"", module("lamp", Lamp.class, ""), module("knob", Switch.class, "")));
    assertThatCode(() -> RobotDryRun.check(robot)).doesNotThrowAnyException();
    assertThatCode(() -> RobotDryRun.checkComplete(robot)).doesNotThrowAnyException();
  }

  @Test
  void refusesAModuleThatIsNamedAndNotThere() throws Exception {
    String wrong = "atrv1/switch: parameter lamp is ";
    assertThat(
            faultsOf(module("switch", Switch.class, named("lmap")), module("lamp", Lamp.class, "")))
        .containsExactly(
            "3: "
                + wrong
                + "\"lmap\", which is not the name of a Shining of atrv1; did you mean \"lamp\"?");
    assertThat(faultsOf(module("switch", Switch.class, named("beacon"))))
        .containsExactly(
            "3: "
                + wrong
                + "\"beacon\", which is not the name of a Shining of atrv1; it has none, so add one"
                + " to its XML");
  }

  @Test
  void refusesAModuleThatIsNamedAndOfAnotherKind() throws Exception {
    assertThat(
            faultsOf(
                module("switch", Switch.class, named("other")),
                module("other", Switch.class, ""),
                module("torch", Lamp.class, "")))
        .containsExactly(
            "3: atrv1/switch: parameter lamp is \"other\", which is not the name of a Shining of"
                + " atrv1; it has torch");
  }

  @Test
  void refusesAWholeRobotThatLacksWhatAModuleNeeds() throws Exception {
    RobotDescription robot = robot(group("name=\"a\"", module("switch", Switch.class, "")));
    assertThatCode(() -> RobotDryRun.check(robot))
        .as("it may come later")
        .doesNotThrowAnyException();
    assertThat(faults(RobotDryRun::checkComplete, robot))
        .containsExactly(
            "3: module atrv1/switch: it needs a Shining, and atrv1 has none; add one to its XML");
  }

  /** What a group with a class path of its own holds is not known here. */
  @Test
  void believesWhatItCannotTry() throws Exception {
    RobotDescription robot =
        robot(
            group("name=\"a\"", module("switch", Switch.class, named("far"))),
            group("name=\"b\"", "<jvm-option>-Dx=y</jvm-option>", module("far", Object.class, "")));
    assertThatCode(() -> RobotDryRun.checkComplete(robot)).doesNotThrowAnyException();
  }

  /** What shines. */
  public interface Shining extends Module {}

  /** Shines. */
  public static final class Lamp extends Still implements Shining {
    public Lamp(ModuleContext context) {
      super(context);
    }
  }

  /** Needs a lamp. */
  public static final class Switch extends Still {
    private final ModuleDependency<Shining> lamp;

    public Switch(ModuleContext context) {
      super(context);
      this.lamp = ModuleDependency.of(context, Shining.class, "lamp");
    }

    @Override
    protected void onStart() {
      throw new AssertionError("it was started, with " + lamp);
    }
  }

  /** Is not to be started. */
  private abstract static class Still extends ModuleImpl {
    Still(ModuleContext context) {
      super(context, "a module", "DFRA", "1");
    }

    @Override
    protected void onStart() {
      throw new AssertionError("it was started");
    }

    @Override
    protected void onClose() {}
  }
}
