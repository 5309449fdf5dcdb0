/**
 * A driver of a device behind a serial link, whole, with its parser, its emulator and its tests:
 * what {@code docs/how-to/write-a-driver.md} shows. The probe is made up.
 */
package org.dfra.example.probe;
