package org.dfra.app.terminal;

import static org.assertj.core.api.Assertions.assertThat;

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
}
