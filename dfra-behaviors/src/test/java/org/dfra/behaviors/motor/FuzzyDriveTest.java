package org.dfra.behaviors.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.Inference;
import org.dfra.core.config.ConfigurationException;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.persona.MotorSchemaAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FuzzyDriveTest {

  private static final String SMALL =
      """
      [System]
      Name='small'
      Type='%1$s'
      NumInputs=4
      NumOutputs=2
      NumRules=1
      AndMethod='min'
      OrMethod='max'
      ImpMethod='min'
      AggMethod='max'
      DefuzzMethod='%2$s'

      """;

  @TempDir Path folder;

  private final ScriptedRobot robot = new ScriptedRobot();

  @AfterEach
  void end() {
    robot.close();
  }

  private FuzzyDriveImpl drive(Path file) {
    return robot.add(
        new FuzzyDriveImpl(
            robot.context(
                "rules",
                Map.of("system_file", file.toString(), "max_speed", "0.5", "max_yaw_rate", "2"))));
  }

  private static Clearance clearance(double left, double centre, double right) {
    return new Clearance(Instant.EPOCH, "base_link", left, centre, right);
  }

  private static HeadingPercept heading(double error) {
    return new HeadingPercept(Instant.EPOCH.plusSeconds(1), "base_link", error, 0, 0, 0, 5, 5);
  }

  @Test
  void answersAsTheSystemItself() {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    FuzzyDriveImpl drive = drive(ScriptedRobot.rules());
    Inference system = FuzzySystem.read(ScriptedRobot.rules()).inference();
    double[] out = new double[2];
    for (int i = 0; i < 500; i++) {
      Clearance clearance =
          clearance(random.nextDouble() * 8, random.nextDouble() * 8, random.nextDouble() * 8);
      HeadingPercept heading = heading((random.nextDouble() - 0.5) * 2 * Math.PI);
      system.evaluate(
          new double[] {
            clearance.left(),
            clearance.centre(),
            clearance.right(),
            Math.toDegrees(heading.headingError())
          },
          out);
      DriveAdvice advice = drive.advise(clearance, heading);
      assertThat(advice.velocity().speed())
          .as("seed %s", seed)
          .isCloseTo(Math.max(0, Math.min(1, out[0])) * 0.5, within(1e-12));
      assertThat(advice.velocity().yawRate())
          .as("seed %s", seed)
          .isCloseTo(Math.max(-1, Math.min(1, out[1])) * 2, within(1e-12));
      assertThat(advice.measured()).as("the older percept's").isEqualTo(Instant.EPOCH);
    }
  }

  @Test
  void turnsToWhereTheHeadingIsAndAwayFromWhatIsNear() {
    FuzzyDriveImpl drive = drive(ScriptedRobot.rules());
    assertThat(drive.advise(clearance(8, 8, 8), heading(1)).velocity().yawRate())
        .as("to the left")
        .isPositive();
    assertThat(drive.advise(clearance(8, 8, 8), heading(-1)).velocity().yawRate()).isNegative();
    assertThat(drive.advise(clearance(8, 0.6, 0.5), heading(0)).velocity().yawRate())
        .as("away from the right")
        .isPositive();
  }

  @Test
  void theOrderOfTheVariablesDoesNotMatter() throws IOException {
    Path other = folder.resolve("other.fis");
    Files.writeString(
        other,
        SMALL.formatted("mamdani", "centroid")
            + input(1, "heading_error", -180, 180)
            + input(2, "right", 0, 8)
            + input(3, "centre", 0, 8)
            + input(4, "left", 0, 8)
            + output(1, "rv", -1, 1)
            + output(2, "tr", 0, 1)
            + "[Rules]\n2 0 0 0, 2 1 (1) : 1\n");
    // Facing to the right of where it is to go, so "up": turn left, slowly.
    DriveAdvice advice = drive(other).advise(clearance(8, 8, 8), heading(Math.toRadians(170)));
    assertThat(advice.velocity().yawRate()).as("%s", advice).isPositive();
    assertThat(advice.velocity().speed()).as("%s", advice).isBetween(0.0, 0.25);
    assertThat(advice.reason()).contains("heading_error", "rv", "tr");
  }

  @Test
  void saysInASentenceWhatAFileLacksOrHasTooMuch() throws IOException {
    String whole = Files.readString(ScriptedRobot.rules());
    Path renamed =
        Files.writeString(folder.resolve("renamed.fis"), whole.replace("'centre'", "'middle'"));
    assertThatThrownBy(() -> drive(renamed))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            renamed
                + ": a waypoint controller needs the inputs left, centre, right, heading_error, each"
                + " once; this system has left, middle, right, heading_error: add centre: remove or"
                + " rename middle");
    Path twice =
        Files.writeString(folder.resolve("twice.fis"), whole.replace("'centre'", "'left'"));
    assertThatThrownBy(() -> drive(twice))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("this system has left, left, right, heading_error: add centre");
    Path output = Files.writeString(folder.resolve("out.fis"), whole.replace("'tr'", "'speed'"));
    assertThatThrownBy(() -> drive(output))
        .hasMessageContaining("needs the outputs tr, rv, each once; this system has speed, rv");
    Path none = folder.resolve("none.fis");
    assertThatThrownBy(() -> drive(none))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("none.fis");
    assertThatThrownBy(() -> new FuzzyDriveImpl(robot.context("rules", Map.of())))
        .hasMessageContaining("atrv1/rules: parameter system_file is not set");
  }

  @Test
  void saysHowItInfers() throws IOException {
    assertThat(drive(ScriptedRobot.rules()).attributes())
        .contains(new MotorSchemaAttributes("Velocity", "mamdani", 135));
    Path sugeno = folder.resolve("sugeno.fis");
    StringBuilder text = new StringBuilder(SMALL.formatted("sugeno", "wtaver"));
    List<String> inputs = List.of("left", "centre", "right");
    inputs.forEach(name -> text.append(input(inputs.indexOf(name) + 1, name, 0, 8)));
    text.append(input(4, "heading_error", -180, 180));
    for (int i = 1; i <= 2; i++) {
      text.append(
          "[Output%d]\nName='%s'\nRange=[0 1]\nNumMFs=1\nMF1='half':'constant',[0.5]\n\n"
              .formatted(i, i == 1 ? "tr" : "rv"));
    }
    Files.writeString(sugeno, text + "[Rules]\n1 0 0 0, 1 1 (1) : 1\n");
    FuzzyDriveImpl drive =
        new FuzzyDriveImpl(robot.context("sugeno", Map.of("system_file", sugeno.toString())));
    assertThat(drive.attributes()).contains(new MotorSchemaAttributes("Velocity", "sugeno", 1));
  }

  private static String input(int number, String name, double least, double most) {
    return variable("Input", number, name, least, most);
  }

  private static String output(int number, String name, double least, double most) {
    return variable("Output", number, name, least, most);
  }

  private static String variable(String kind, int number, String name, double a, double b) {
    return "[%s%d]\nName='%s'\nRange=[%s %s]\nNumMFs=2\nMF1='down':'trimf',[%s %s %s]\n"
            .formatted(kind, number, name, a, b, a, a, b)
        + "MF2='up':'trimf',[%s %s %s]\n\n".formatted(a, b, b);
  }
}
