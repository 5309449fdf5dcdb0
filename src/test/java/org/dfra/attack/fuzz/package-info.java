/** Malformed bytes for each port of a robot. Enter at {@link org.dfra.attack.fuzz.FuzzIT}. */
package org.dfra.attack.fuzz;
