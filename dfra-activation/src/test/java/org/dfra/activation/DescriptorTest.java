package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupDesc.CommandEnvironment;
import java.rmi.activation.ActivationGroupID;
import java.util.List;
import java.util.Properties;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Descriptors: immutable, equal by content, and whole after a round trip. */
class DescriptorTest {

  private final ActivationGroupID group = new ActivationGroupID(null);

  @BeforeEach
  void noGroupInThisJvm() {
    FreshJvm.pretend();
  }

  @Test
  void objectDescriptorsAreEqualInEveryPartOrNotAtAll() throws Exception {
    MarshalledObject<String> data = new MarshalledObject<>("gps.properties");
    ActivationDesc desc = new ActivationDesc(group, "GPS", "file:gps.jar", data, true);
    ActivationDesc same =
        new ActivationDesc(
            group, "GPS", "file:gps.jar", new MarshalledObject<>("gps.properties"), true);

    assertThat(desc).isEqualTo(same).hasSameHashCodeAs(same);
    assertThat(
            List.of(
                "a descriptor?",
                new ActivationDesc(new ActivationGroupID(null), "GPS", "file:gps.jar", data, true),
                new ActivationDesc(group, "Laser", "file:gps.jar", data, true),
                new ActivationDesc(group, "GPS", null, data, true),
                new ActivationDesc(group, "GPS", "file:gps.jar", null, true),
                new ActivationDesc(group, "GPS", "file:gps.jar", data)))
        .noneMatch(desc::equals);
  }

  @Test
  void objectDescriptorIsWholeAfterARoundTrip() throws Exception {
    MarshalledObject<String> data = new MarshalledObject<>("gps.properties");
    ActivationDesc desc = new ActivationDesc(group, "GPS", "file:gps.jar", data, true);
    ActivationDesc read = (ActivationDesc) Streams.roundTrip(desc);

    assertThat(read).isEqualTo(desc).isNotSameAs(desc);
    assertThat(read.getGroupID()).isEqualTo(group);
    assertThat(read.getClassName()).isEqualTo("GPS");
    assertThat(read.getLocation()).isEqualTo("file:gps.jar");
    assertThat(read.getData().get()).isEqualTo("gps.properties");
    assertThat(read.getRestartMode()).isTrue();
    ActivationDesc bare = new ActivationDesc(group, "GPS", null, null);
    assertThat(Streams.roundTrip(bare)).isEqualTo(bare);
    assertThat(bare.getRestartMode()).isFalse();
  }

  @Test
  void objectDescriptorNeedsAGroup() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new ActivationDesc((ActivationGroupID) null, "GPS", null, null))
        .withMessage(
            "The descriptor of GPS has no group:"
                + " give the ActivationGroupID that registerGroup returned.");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> new ActivationDesc("GPS", null, null))
        .withMessage(
            "The descriptor of GPS has no group, and this JVM has no active group: give an"
                + " ActivationGroupID, or call ActivationGroup.createGroup first.");
  }

  @Test
  void groupDescriptorsAreEqualInEveryPartOrNotAtAll() throws Exception {
    MarshalledObject<String> data = new MarshalledObject<>("front");
    CommandEnvironment java = new CommandEnvironment("java", new String[] {"-Xmx64m"});
    ActivationGroupDesc desc = new ActivationGroupDesc("G", "file:g.jar", data, props("1"), java);
    ActivationGroupDesc same =
        new ActivationGroupDesc(
            "G",
            "file:g.jar",
            new MarshalledObject<>("front"),
            props("1"),
            new CommandEnvironment("java", new String[] {"-Xmx64m"}));

    assertThat(desc).isEqualTo(same).hasSameHashCodeAs(same);
    assertThat(
            List.of(
                "a descriptor?",
                new ActivationGroupDesc("H", "file:g.jar", data, props("1"), java),
                new ActivationGroupDesc("G", null, data, props("1"), java),
                new ActivationGroupDesc("G", "file:g.jar", null, props("1"), java),
                new ActivationGroupDesc("G", "file:g.jar", data, props("2"), java),
                new ActivationGroupDesc("G", "file:g.jar", data, null, java),
                new ActivationGroupDesc("G", "file:g.jar", data, props("1"), null)))
        .noneMatch(desc::equals);
    assertThat(java).isNotEqualTo(new CommandEnvironment("java", null)).isNotEqualTo("java");
    assertThat(java).isNotEqualTo(new CommandEnvironment(null, new String[] {"-Xmx64m"}));
  }

  @Test
  void groupDescriptorIsWholeAfterARoundTrip() throws Exception {
    CommandEnvironment java = new CommandEnvironment("java", new String[] {"-Xmx64m"});
    ActivationGroupDesc full =
        new ActivationGroupDesc("G", "file:g.jar", new MarshalledObject<>("x"), props("1"), java);
    ActivationGroupDesc read = (ActivationGroupDesc) Streams.roundTrip(full);

    assertThat(read).isEqualTo(full);
    assertThat(read.getClassName()).isEqualTo("G");
    assertThat(read.getLocation()).isEqualTo("file:g.jar");
    assertThat(read.getData().get()).isEqualTo("x");
    assertThat(read.getPropertyOverrides()).containsEntry("robot", "1");
    assertThat(read.getCommandEnvironment().getCommandPath()).isEqualTo("java");
    assertThat(read.getCommandEnvironment().getCommandOptions()).containsExactly("-Xmx64m");
  }

  @Test
  void groupDescriptorMayBeEmpty() throws Exception {
    ActivationGroupDesc read =
        (ActivationGroupDesc) Streams.roundTrip(new ActivationGroupDesc(null, null));

    assertThat(read).isEqualTo(new ActivationGroupDesc(null, null));
    assertThat(read.getClassName()).isNull();
    assertThat(read.getData()).isNull();
    assertThat(read.getPropertyOverrides()).isNull();
    assertThat(read.getCommandEnvironment()).isNull();
    CommandEnvironment command =
        (CommandEnvironment) Streams.roundTrip(new CommandEnvironment(null, null));
    assertThat(command.getCommandPath()).isNull();
    assertThat(command.getCommandOptions()).isEmpty();
  }

  @Test
  void groupDescriptorCannotBeChangedFromOutside() {
    Properties given = props("1");
    String[] options = {"-Xmx64m"};
    CommandEnvironment command = new CommandEnvironment("java", options);
    ActivationGroupDesc desc = new ActivationGroupDesc(given, command);
    given.setProperty("robot", "2");
    desc.getPropertyOverrides().setProperty("robot", "3");
    options[0] = "-Xmx1m";
    command.getCommandOptions()[0] = "-Xmx2m";

    assertThat(desc.getPropertyOverrides()).containsEntry("robot", "1");
    assertThat(command.getCommandOptions()).containsExactly("-Xmx64m");
  }

  private static Properties props(String robot) {
    Properties properties = new Properties();
    properties.setProperty("robot", robot);
    return properties;
  }
}
