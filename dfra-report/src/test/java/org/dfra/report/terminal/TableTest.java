package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class TableTest {

  @Test
  void eachColumnIsAsWideAsItsWidestCell() {
    Table table = new Table("NAME", "VALUE");
    table.row("rate", "1");
    table.row("idle_rate", "10");
    assertThat(table.lines()).containsExactly("NAME       VALUE", "rate       1", "idle_rate  10");
  }

  @Test
  void aLongCellGoesOnBelowWhereItBegan() {
    Table table = new Table("NAME", "VALUE", "SETTABLE");
    table.row("satellites", "G14 used; ".repeat(7).strip(), "no");
    table.row("rate", "1", "yes");
    assertThat(table.lines())
        .containsExactly(
            "NAME        VALUE                                                        SETTABLE",
            "satellites  G14 used; G14 used; G14 used; G14 used; G14 used; G14 used;  no",
            "            G14 used;",
            "rate        1                                                            yes");
  }

  @Test
  void aWordIsNotBroken() {
    String link = "serial:/dev/" + "a".repeat(100);
    Table table = new Table("LINK");
    table.row("at " + link);
    assertThat(table.lines()).containsExactly("LINK", "at", link);
  }

  private static Table wide() {
    Table table = new Table("MODULE", "KIND", "STATE", "CLIENTS", "HOST", "SEEN");
    table.row(
        "surveyor-north-field/gps_front_left",
        "GPSSensor, LocationSensor",
        "ready, EMERGENCY STOP",
        "12",
        "robot-17.field.example",
        "stale, 12.5 s ago");
    table.row("a/b", "GPSSensor", "ready", "0", "127.0.0.1", "now");
    return table;
  }

  @Test
  void isNoWiderThanTheTerminalAndFoldsByWord() {
    for (int columns : new int[] {100, 90}) {
      assertThat(wide().lines(columns))
          .as("%d columns", columns)
          .allMatch(line -> line.length() <= columns)
          .anyMatch(line -> line.contains("surveyor-north-field/gps_front_left"))
          .anyMatch(line -> line.contains("12.5 s"));
    }
  }

  @Test
  void whereWordsAreTooLongEachCellHasALineOfItsOwn() {
    List<String> lines = wide().lines(80);
    assertThat(lines)
        .allMatch(line -> line.length() <= 80)
        .contains(
            "MODULE   surveyor-north-field/gps_front_left",
            "STATE    ready, EMERGENCY STOP",
            "CLIENTS  12",
            "MODULE   a/b");
  }

  @Test
  void whatBelongsTogetherStaysOnOneLine() {
    Table table = new Table("STATE", "DO");
    table.row("ready, EMERGENCY STOP", "Release it: ./dfra stop --release atrv1");
    assertThat(table.lines(43))
        .containsExactly(
            "STATE           DO",
            "ready,          Release it:",
            "EMERGENCY STOP  ./dfra stop --release atrv1");
  }

  @Test
  void fitsExactlyWhereItCan() {
    Table table = new Table("A", "B");
    table.row("one two three", "x");
    assertThat(table.lines(16)).containsExactly("A              B", "one two three  x");
    assertThat(table.lines(15)).isEqualTo(List.of("A             B", "one two       x", "  three"));
  }
}
