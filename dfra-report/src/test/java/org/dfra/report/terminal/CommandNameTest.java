package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;

/** Hints on what to type are of use where DFRA is installed, too. */
class CommandNameTest {

  @Test
  void hintsAreWrittenAsTheyAreTypedWhereItIsInstalled() {
    StringWriter written = new StringWriter();
    PrintWriter out = new CommandName.Renaming(new PrintWriter(written), "dfra");
    out.println("none is up; ./dfra up ROBOT.XML brings one up, ./dfra status tells");
    out.print("in ./dfra-cli nothing changes");
    out.flush();
    assertThat(written.toString())
        .isEqualTo(
            "none is up; dfra up ROBOT.XML brings one up, dfra status tells"
                + System.lineSeparator()
                + "in ./dfra-cli nothing changes");
  }

  @Test
  void aCheckoutIsNotInstalled() {
    PrintWriter plain = new PrintWriter(new StringWriter());
    assertThat(CommandName.isInstalled()).isFalse();
    assertThat(CommandName.replacingName(plain)).isSameAs(plain);
  }
}
