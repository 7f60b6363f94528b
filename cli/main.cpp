// The command `durer`.
int main() { return 1; }
